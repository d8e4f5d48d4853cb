/* The force loop against a scalar loop over all pairs, for every law, kernel and layout over threads. */
#include "contact/force.h"
#include "contact/law_kernel.h"
#include "core/random.h"
#include "pairs_by_hand.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include "near.h"

enum { COUNT = 200, MATERIALS = 3, LAWS = 24 };

static const double edge = 4.8;
static const char *const kernels[] = {"baseline", "x86-64-v3", "x86-64-v4"};

/* Law number k of all that the loop specialises, and some with other options. */
static struct law law_number(int k, int materials) {
    static struct law_pair pair[LAW_MATERIALS_MAX][LAW_MATERIALS_MAX];
    struct law_material material[MATERIALS];
    for (int a = 0; a < MATERIALS; a++)
        material[a] = (struct law_material){"m", 1.0, 1e5 * (1.0 + a), 0.2 + 0.1 * a};
    for (int a = 0; a < MATERIALS; a++)
        for (int b = a; b < MATERIALS; b++)
            pair[a][b] = (struct law_pair){.restitution = 0.4 + 0.1 * a,
                                           .friction = 0.2 + 0.1 * b,
                                           .rolling_friction = 0.1,
                                           .k_n = 1e3 * (1.0 + a + b),
                                           .k_t = 4e2 * (1.0 + a),
                                           .gamma_n = 5.0,
                                           .gamma_t = 2.0};
    struct law_options o = law_options_default();
    int friction = k / 3 % 5;
    o.normal = k % 3 == 2 ? LAW_HERTZ : LAW_HOOKE;
    o.damping = k % 3 == 0 ? LAW_DAMPING_COEFFICIENT : LAW_DAMPING_RESTITUTION;
    o.tangential = friction == 0 ? LAW_FRICTIONLESS : LAW_TANGENTIAL_HISTORY;
    o.rolling = friction > 2 ? LAW_ROLLING_SPRING : LAW_ROLLING_NONE;
    o.synchronised = friction == 2 || friction == 4;
    o.end = k >= 15 ? LAW_END_FORCE : LAW_END_OVERLAP;
    o.lammps_hooke = k >= 15 && o.normal == LAW_HOOKE && !o.synchronised;
    struct law law;
    struct error error = {0};
    if (!law_prepare(&law, &o, materials, material, pair, &error))
        fail_msg("%s", error.text);
    return law;
}

/* A dense random cloud in a periodic cube: small spheres and a few of three times the size. */
static struct particles *cloud(const struct law *law, size_t count, double box) {
    unsigned features = (law->spin ? PARTICLE_SPIN : 0u) | (law->materials > 1 ? PARTICLE_MATERIAL : 0u);
    struct particles *p = particles_create(features, count);
    for (size_t k = 0; k < count; k++) {
        struct random_sequence r = random_sequence(7, RANDOM_TEST, k);
        particles_append(p);
        struct particle_state *s = &p->state[k];
        s->radius = k % 25 == 0 ? 1.2 : 0.3 + 0.1 * random_uniform(&r);
        s->inverse_mass = 1.0 / particles_sphere_mass(s->radius, 1.0);
        for (int c = 0; c < 3; c++) {
            s->x[c] = box * random_uniform(&r);
            s->v[c] = random_normal(&r);
            double omega = 2.0 * random_normal(&r); /* drawn in any case: the same cloud for all laws */
            if (law->spin)
                p->omega[k][c] = omega;
        }
        if (law->materials > 1)
            p->material[k] = (uint8_t)(k % (size_t)law->materials);
        p->id[k] = (int64_t)((k * 7919) % count + 1);
    }
    return p;
}

/* Springs of all ordered pairs of particles and images, by brute force. */
struct spring_table {
    double (*value)[6];
};

static double *spring_of(const struct spring_table *t, size_t i, size_t j, unsigned code) {
    return t->value[(i * COUNT + j) * BOX_IMAGE_CODES + code];
}

static struct law_vector vector_of(const double a[3]) {
    return (struct law_vector){a[0], a[1], a[2]};
}

static void add_vector(double *sum, double sign, struct law_vector a) {
    sum[0] += sign * a.x;
    sum[1] += sign * a.y;
    sum[2] += sign * a.z;
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
                             .coefficients = law->pair[particles_material(p, i)][particles_material(p, j)]};
    struct law_vector half = law_add(d, -0.5 * dt, in.velocity);
    in.normal = law_scale(1.0 / sqrt(law_dot(d, d)), d);
    in.half_normal = law_scale(1.0 / sqrt(law_dot(half, half)), half);
    if (law->spin) {
        double cut = law->options.normal == LAW_HERTZ ? 0.5 * in.overlap : 0.0;
        in.surface = law_add(law_scale(a->radius - cut, vector_of(p->omega[i])), b->radius - cut,
                             vector_of(p->omega[j]));
        in.spin = law_add(vector_of(p->omega[j]), -1.0, vector_of(p->omega[i]));
    }
    return in;
}

/* All contacts of the cloud once, forces into `force` (8 a particle); returns the sums. */
static struct force_sums plain_forces(const struct particles *p, const struct law *law, double dt,
                                      const double shift[BOX_IMAGE_CODES][4], struct spring_table *springs,
                                      double (*force)[8]) {
    struct force_sums sums = {0};
    struct law_case kind = law_case_of(&law->options, true);
    for (size_t i = 0; i < p->owned; i++)
        for (size_t j = i + 1; j < p->owned; j++)
            for (unsigned code = 0; code < BOX_IMAGE_CODES; code++) {
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
                double cut = kind.hertz ? 0.5 * in.overlap : 0.0;
                add_vector(force[i], -1.0, out.force);
                add_vector(force[j], 1.0, out.force);
                add_vector(force[i] + 4, p->state[i].radius - cut, out.moment);
                add_vector(force[j] + 4, p->state[j].radius - cut, out.moment);
                add_vector(force[i] + 4, -1.0, out.rolling);
                add_vector(force[j] + 4, 1.0, out.rolling);
                sums.elastic_normal += out.normal_energy;
                sums.elastic_tangential += out.spring_energy;
                sums.dissipated += out.dissipated;
                double length = in.overlap - p->state[i].radius - p->state[j].radius;
                sums.virial[0] -= length * in.normal.x * out.force.x;
                sums.virial[3] -= 0.5 * length * (in.normal.x * out.force.y + in.normal.y * out.force.x);
                sums.contacts++;
                double smaller = fmin(p->state[i].radius, p->state[j].radius);
                sums.overlap_max = fmax(sums.overlap_max, in.overlap / smaller);
            }
    return sums;
}

/* Moves the particles on, without forces: contacts come and go. */
static void drift(struct particles *p, double dt) {
    for (size_t k = 0; k < p->owned; k++)
        for (int c = 0; c < 3; c++)
            p->state[k].x[c] += dt * p->state[k].v[c];
    memset(p->force, 0, p->owned * (size_t)p->force_stride * sizeof *p->force);
}

struct layout {
    int threads;
    double busy;
    const char *kernel;
};

/* Lists of the cloud, one for each layout that the tests use: they depend on no law. */
static struct pairlist lists[4];
static const struct layout list_layouts[4] = {{1, 0.0, NULL}, {2, 0.0, NULL}, {3, 1.0, NULL}, {2, 1.0, NULL}};

static int make_lists(void **state) {
    (void)state;
    struct law law = {.materials = 1};
    struct particles *p = cloud(&law, COUNT, edge);
    for (int l = 0; l < 4; l++)
        hand_make(&lists[l], p,
                  &(struct hand_options){.threads = list_layouts[l].threads,
                                         .margin = 0.1,
                                         .edge = edge,
                                         .busy = list_layouts[l].busy});
    particles_destroy(&p);
    return 0;
}

static int free_lists(void **state) {
    (void)state;
    for (int l = 0; l < 4; l++)
        hand_free(&lists[l]);
    return 0;
}

/* A force loop over a cloud, with all that it needs. */
struct rig {
    struct particles *particles;
    struct pairlist list; /* borrows its arrays from `lists` */
    struct history *history;
    struct force_loop *loop;
    struct force_context context;
    struct force_sums sums;
};

/* False if this CPU lacks the kernel. */
static bool rig_make(struct rig *rig, const struct law *law, struct layout layout) {
    *rig = (struct rig){.loop = force_loop_create(layout.threads)};
    if (layout.kernel && !force_loop_choose(rig->loop, layout.kernel)) {
        force_loop_destroy(&rig->loop);
        return false;
    }
    rig->particles = cloud(law, COUNT, edge);
    for (int l = 0; l < 4; l++)
        if (list_layouts[l].threads == layout.threads && list_layouts[l].busy == layout.busy)
            rig->list = lists[l];
    if (law->history_components)
        rig->history = history_create(law->history_components, layout.threads);
    rig->context = (struct force_context){.particles = rig->particles,
                                          .list = &rig->list,
                                          .history = rig->history,
                                          .law = law,
                                          .want_sums = true};
    force_loop_prepare(rig->loop, &rig->context);
    return true;
}

static void rig_free(struct rig *rig) {
    force_loop_destroy(&rig->loop);
    if (rig->history)
        history_destroy(&rig->history);
    particles_destroy(&rig->particles);
}

/* The first evaluation and two steps. */
static void rig_run(struct rig *rig) {
    for (int n = 0; n < 3; n++) {
        rig->context.dt = n == 0 ? 0.0 : 2e-3;
        drift(rig->particles, rig->context.dt);
        force_loop_run(rig->loop, &rig->context, &rig->sums);
    }
}

static void check_sums(const struct force_sums *got, const struct force_sums *want) {
    assert_int_equal(got->contacts, want->contacts);
    assert_int_equal(got->contact_sides, 2 * want->contacts);
    assert_near(got->overlap_max, want->overlap_max, 1e-12);
    assert_near(got->elastic_normal / want->elastic_normal, 1.0, 1e-11);
    assert_near(got->elastic_tangential, want->elastic_tangential, 1e-11 * want->elastic_normal);
    assert_near(got->dissipated, want->dissipated, 1e-11 * want->elastic_normal);
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
        memory_allocate((size_t)COUNT * COUNT * BOX_IMAGE_CODES, sizeof *springs.value, "springs")};
    for (int k = 0; k < LAWS; k++) {
        struct law law = law_number(k, k % 2 ? 1 : MATERIALS);
        struct particles *p = cloud(&law, COUNT, edge);
        struct rig rig;
        double(*force)[8] = memory_allocate_zero(COUNT, sizeof *force, "forces");
        struct force_sums sums = {0};
        memset(springs.value, 0, (size_t)COUNT * COUNT * BOX_IMAGE_CODES * sizeof *springs.value);
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

/* All kernels give the same bits, forces and springs. */
static void test_kernels_agree(void **state) {
    (void)state;
    for (int k = 0; k < LAWS; k++) {
        struct law law = law_number(k, k % 2 ? 1 : MATERIALS);
        struct rig first, other;
        rig_make(&first, &law, (struct layout){2, 1.0, kernels[0]});
        rig_run(&first);
        for (size_t c = 1; c < sizeof kernels / sizeof kernels[0]; c++) {
            if (!rig_make(&other, &law, (struct layout){2, 1.0, kernels[c]}))
                continue;
            assert_string_equal(force_loop_kernel(other.loop), kernels[c]);
            rig_run(&other);
            assert_memory_equal(first.particles->force, other.particles->force,
                                COUNT * (size_t)first.particles->force_stride * sizeof(double));
            assert_memory_equal(&first.sums, &other.sums, sizeof first.sums);
            for (int t = 0; first.history && t < 2; t++) {
                const struct history_part *a = &first.history->part[first.history->now][t];
                const struct history_part *b = &other.history->part[other.history->now][t];
                assert_int_equal(a->count, b->count);
                assert_memory_equal(a->pair, b->pair, a->count * sizeof *a->pair);
                assert_memory_equal(a->value, b->value,
                                    a->count * (size_t)law.history_components * sizeof *a->value);
            }
            rig_free(&other);
        }
        rig_free(&first);
    }
}

/* Momentum is conserved, and with levers that meet in the middle of the overlap (hertz) angular momentum too.
 */
static void test_conservation(void **state) {
    (void)state;
    for (int k = 0; k < LAWS; k++) {
        struct law law = law_number(k, MATERIALS);
        struct rig rig;
        rig_make(&rig, &law, (struct layout){3, 1.0, NULL});
        for (int code = 1; code < BOX_IMAGE_CODES; code++)
            for (int c = 0; c < 3; c++)
                rig.list.shift[code][c] = 100.0; /* no contact over the box's sides */
        rig_run(&rig);
        struct law_vector force = {0}, torque = {0};
        double size = 0.0;
        for (size_t i = 0; i < COUNT; i++) {
            const double *f = rig.particles->force + i * (size_t)rig.particles->force_stride;
            struct law_vector x = vector_of(rig.particles->state[i].x);
            force = law_add(force, 1.0, vector_of(f));
            torque = law_add(torque, 1.0, law_cross(x, vector_of(f)));
            if (law.spin)
                torque = law_add(torque, 1.0, vector_of(f + 4));
            size += sqrt(law_dot(vector_of(f), vector_of(f)));
        }
        assert_true(sqrt(law_dot(force, force)) < 1e-14 * size);
        if (!law.spin || law.options.normal == LAW_HERTZ)
            assert_true(sqrt(law_dot(torque, torque)) < 1e-13 * size * edge);
        rig_free(&rig);
    }
}

/* Springs of a pair that two threads compute are opposite to the last bit. */
static void test_mirrored_springs(void **state) {
    (void)state;
    struct law law = law_number(13, 1);
    struct rig rig;
    rig_make(&rig, &law, (struct layout){2, 0.0, NULL});
    rig_run(&rig);
    size_t found = 0;
    for (int t = 0; t < 2; t++) {
        const struct history_part *mine = &rig.history->part[rig.history->now][t];
        const struct history_part *theirs = &rig.history->part[rig.history->now][1 - t];
        for (size_t a = 0; a < mine->count; a++) {
            size_t k = pairlist_thread_first(&rig.list, t) + mine->pair[a];
            for (size_t b = 0; b < theirs->count; b++) {
                size_t l = pairlist_thread_first(&rig.list, 1 - t) + theirs->pair[b];
                unsigned code = pair_image(rig.list.j[k]);
                if (rig.list.i[k] != pair_partner(rig.list.j[l]) ||
                    rig.list.i[l] != pair_partner(rig.list.j[k]) ||
                    pair_image(rig.list.j[l]) != box_image_opposite(code))
                    continue;
                for (int c = 0; c < 6; c++)
                    assert_true(mine->value[6 * a + (size_t)c] == -theirs->value[6 * b + (size_t)c]);
                found++;
            }
        }
    }
    assert_true(found > 100);
    rig_free(&rig);
}

/* The contact list holds each contact once and gives the forces back. */
static void test_contacts(void **state) {
    (void)state;
    for (int k = 0; k < 15; k++) {
        struct law law = law_number(k, MATERIALS);
        struct rig rig;
        rig_make(&rig, &law, (struct layout){3, 1.0, NULL});
        rig_run(&rig);
        rig.context.dt = 0.0; /* evaluate again with springs at rest: what the list shows */
        drift(rig.particles, 0.0);
        force_loop_run(rig.loop, &rig.context, &rig.sums);
        struct force_contact *contacts;
        size_t count = force_loop_contacts(&rig.context, &contacts);
        assert_int_equal(count, rig.sums.contacts);
        double sum[COUNT + 1][3] = {{0}};
        for (size_t c = 0; c < count; c++) {
            assert_true(contacts[c].overlap > 0.0);
            for (int d = 0; d < 3; d++) {
                sum[contacts[c].id_i][d] -= contacts[c].force[d];
                sum[contacts[c].id_j][d] += contacts[c].force[d];
            }
        }
        for (size_t i = 0; i < COUNT; i++)
            for (int d = 0; d < 3; d++)
                assert_near(sum[rig.particles->id[i]][d],
                            rig.particles->force[i * (size_t)rig.particles->force_stride + (size_t)d], 1e-8);
        memory_free(contacts);
        rig_free(&rig);
    }
}

/* Prescribed particles, coincident centres and pairs that only touch do no harm. */
static void test_degenerate(void **state) {
    (void)state;
    for (int k = 0; k < 15; k++) {
        struct law law = law_number(k, 1);
        struct rig rig;
        rig_make(&rig, &law, (struct layout){1, 0.0, NULL});
        struct particle_state *s = rig.particles->state;
        for (size_t i = 0; i < COUNT; i++)
            for (int c = 0; c < 3; c++)
                s[i].x[c] = 10.0 * (double)i;
        s[0].inverse_mass = s[1].inverse_mass = 0.0; /* a prescribed pair overlaps */
        uint32_t i[3 + INDEX_SINK_PAD] = {0, 2, 4}, j[3 + INDEX_SINK_PAD] = {1, 3, 5};
        struct pair_block block = {.one_sided = 3, .slotted = 3, .end_pair = 3};
        rig.list = (struct pairlist){
            .i = i, .j = j, .blocks = &block, .block_count = 1, .threads = 1, .thread_block = (int[]){0, 1}};
        s[1].x[0] = s[0].x[0] + 0.5;
        memcpy(s[3].x, s[2].x, sizeof s[3].x);             /* the same place */
        s[5].x[0] = s[4].x[0] + s[4].radius + s[5].radius; /* touching */
        s[5].x[1] = s[4].x[1], s[5].x[2] = s[4].x[2];
        s[1].x[1] = s[0].x[1], s[1].x[2] = s[0].x[2];
        rig.context.dt = 1e-3;
        force_loop_run(rig.loop, &rig.context, &rig.sums);
        assert_int_equal(rig.sums.contacts, 2);
        for (size_t c = 0; c < 6 * (size_t)rig.particles->force_stride; c++)
            assert_true(isfinite(rig.particles->force[c]));
        assert_true(rig.particles->force[0] < 0.0);
        rig_free(&rig);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_plain), cmocka_unit_test(test_kernels_agree),
        cmocka_unit_test(test_conservation),  cmocka_unit_test(test_mirrored_springs),
        cmocka_unit_test(test_contacts),      cmocka_unit_test(test_degenerate)};
    return cmocka_run_group_tests(tests, make_lists, free_lists);
}
