/* SPDX-License-Identifier: BSD-3-Clause */
/* The force loop against a scalar loop over all pairs, for every law, kernel and layout over threads. */
#include "tests/test.h"

#include "tests/physics/grains/forces_by_hand.h"

/* Springs of all ordered pairs of particles and images, by brute force. */
struct spring_table {
    double (*value)[6];
};

static double *spring_of(const struct spring_table *t, size_t i, size_t j, unsigned code) {
    return t->value[(i * COUNT + j) * IMAGE_CODES + code];
}

static bool plain_touch(const struct particle_state *a, const struct particle_state *b,
                        const double shift[3]) {
    double x = b->x[0] - a->x[0] + shift[0], y = b->x[1] - a->x[1] + shift[1],
           z = b->x[2] - a->x[2] + shift[2];
    return x * x + y * y + z * z < (a->radius + b->radius) * (a->radius + b->radius);
}

/* The law's input for a pair, written plainly. */
static struct law_contact plain_contact(const struct particles *p, const struct law *law, size_t i, size_t j,
                                        const double shift[3], double dt) {
    const struct particle_state *a = &p->state[i], *b = &p->state[j];
    struct law_vector d = law_add(law_add(vector_of(b->x), -1.0, vector_of(a->x)), 1.0, vector_of(shift));
    struct law_contact in = {.overlap = a->radius + b->radius - sqrt(law_dot(d, d)),
                             .mass = 1.0 / (a->inverse_mass + b->inverse_mass),
                             .radius = 1.0 / (1.0 / a->radius + 1.0 / b->radius),
                             .velocity = law_add(vector_of(b->v), -1.0, vector_of(a->v)),
                             .coefficients =
                                 law->pair[law_place_of(law->materials, material_of(material_numbers(p), i),
                                                        material_of(material_numbers(p), j))]};
    struct law_vector half = law_add(d, -0.5 * dt, in.velocity);
    in.normal = law_scale(1.0 / sqrt(law_dot(d, d)), d);
    in.half_normal = law_scale(1.0 / sqrt(law_dot(half, half)), half);
    if (law->spin) {
        double distance = sqrt(law->options.synchronised ? law_dot(half, half) : law_dot(d, d));
        double cut = law->options.lammps_history ? 0.0 : 0.5 * (a->radius + b->radius - distance);
        in.surface = law_add(law_scale(a->radius - cut, vector_of(spin_of(p)[i])), b->radius - cut,
                             vector_of(spin_of(p)[j]));
        in.spin = law_add(vector_of(spin_of(p)[j]), -1.0, vector_of(spin_of(p)[i]));
    }
    return in;
}

/* All contacts of the cloud once, forces into `force` (8 a particle); returns the sums. */
static struct force_sums plain_forces(const struct particles *p, const struct law *law, double dt,
                                      const double shift[IMAGE_CODES][4], struct spring_table *springs,
                                      double (*force)[8]) {
    struct force_sums sums = {0};
    struct law_case kind = law_case_of(&law->options, true);
    for (size_t i = 0; i < p->owned; i++)
        for (size_t j = i + 1; j < p->owned; j++)
            for (unsigned code = 0; code < IMAGE_CODES; code++) {
                double *spring = spring_of(springs, i, j, code);
                struct law_contact in = {0};
                if (plain_touch(&p->state[i], &p->state[j], shift[code]))
                    in = plain_contact(p, law, i, j, shift[code], dt);
                if (in.overlap <= 0.0) {
                    memset(spring, 0, 6 * sizeof *spring);
                    continue;
                }
                in.spring = vector_of(spring);
                in.roll = vector_of(spring + 3);
                struct law_response out = law_respond(kind, law_step_of(&law->options, dt), &in);
                memcpy(spring, &out.spring, 3 * sizeof *spring);
                memcpy(spring + 3, &out.roll, 3 * sizeof *spring);
                double cut = law->options.lammps_history ? 0.0 : 0.5 * in.overlap;
                add_vector(force[i], -1.0, out.force);
                add_vector(force[j], 1.0, out.force);
                add_vector(force[i] + 4, p->state[i].radius - cut, out.moment);
                add_vector(force[j] + 4, p->state[j].radius - cut, out.moment);
                add_vector(force[i] + 4, -1.0, out.rolling);
                add_vector(force[j] + 4, 1.0, out.rolling);
                sums.elastic_normal += out.normal_energy;
                sums.elastic_tangential += out.spring_energy;
                sums.taken += out.taken;
                double length = in.overlap - p->state[i].radius - p->state[j].radius;
                sums.virial[0] -= length * in.normal.x * out.force.x;
                sums.virial[3] -= 0.5 * length * (in.normal.x * out.force.y + in.normal.y * out.force.x);
                sums.contacts++;
                double smaller = fmin(p->state[i].radius, p->state[j].radius);
                sums.overlap_max = fmax(sums.overlap_max, in.overlap / smaller);
            }
    return sums;
}

static void check_sums(const struct force_sums *got, const struct force_sums *want) {
    assert_int_equal(got->contacts, want->contacts);
    assert_int_equal(got->contact_sides, 2 * want->contacts);
    assert_near(got->overlap_max, want->overlap_max, 1e-12);
    assert_near(got->elastic_normal / want->elastic_normal, 1.0, 1e-11);
    assert_near(got->elastic_tangential, want->elastic_tangential, 1e-11 * want->elastic_normal);
    assert_near(got->taken, want->taken, 1e-11 * want->elastic_normal);
    assert_near(got->virial[0] / want->virial[0], 1.0, 1e-11);
    assert_near(got->virial[3], want->virial[3], 1e-11 * fabs(want->virial[0]));
}

/* Forces of the loop against the plain sums, relative to the largest force. */
static void check_forces(const struct particles *p, double (*want)[8]) {
    double largest = 0.0;
    for (size_t k = 0; k < p->owned; k++)
        for (int c = 0; c < 3; c++)
            largest = fmax(largest, fabs(want[k][c]));
    for (size_t k = 0; k < p->owned; k++)
        for (int c = 0; c < p->force_stride; c++)
            assert_near(p->force[k * (size_t)p->force_stride + (size_t)c], want[k][c], 1e-12 * largest);
}

static void test_against_plain(void **state) {
    (void)state;
    const struct layout layouts[] = {{1, 0.0, NULL}, {2, 0.0, NULL}, {3, 1.0, NULL}};
    struct spring_table springs = {
        memory_allocate((size_t)COUNT * COUNT * IMAGE_CODES, sizeof *springs.value, "springs")};
    for (int k = 0; k < LAWS; k++) {
        OWN_LAW law = law_number(k, k / 2 % 3 ? 1 : MATERIALS);
        struct particles *p = cloud(&law, COUNT, edge);
        struct rig rig;
        double(*force)[8] = memory_allocate_zero(COUNT, sizeof *force, "forces");
        struct force_sums sums = {0};
        memset(springs.value, 0, (size_t)COUNT * COUNT * IMAGE_CODES * sizeof *springs.value);
        rig_make(&rig, &law, layouts[0]);
        for (int n = 0; n < 3; n++) {
            double dt = n == 0 ? 0.0 : 2e-3;
            drift(p, dt);
            memset(force, 0, COUNT * sizeof *force);
            sums = plain_forces(p, &law, dt, rig.list.shift, &springs, force);
        }
        rig_free(&rig);
        for (size_t l = 0; l < sizeof layouts / sizeof layouts[0]; l++) {
            rig_make(&rig, &law, layouts[l]);
            rig_run(&rig);
            check_forces(rig.particles, force);
            check_sums(&rig.sums, &sums);
            rig_free(&rig);
        }
        memory_free(force);
        particles_destroy(&p);
    }
    memory_free(springs.value);
}

TEST_MAIN_GROUP(force, make_lists, free_lists, cmocka_unit_test(test_against_plain))
