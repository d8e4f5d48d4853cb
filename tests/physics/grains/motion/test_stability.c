/* SPDX-License-Identifier: BSD-3-Clause */
/* The bound on the stable step against the largest frequency of an assembly, found by power iteration of its
 * dynamic matrix contact by contact: never above, and how near; for crystals, random clouds, sizes apart by
 * 50. */
#include "tests/test.h"

#include "physics/grains/motion/stability.h"
#include "physics/grains/motion/timestep.h"
#include "tests/physics/grains/forces_by_hand.h"

enum { ITERATIONS = 400 };

/* A packing under test. */
struct packing {
    struct particles *particles;
    double edge; /* periodic cube; 0: open */
};

static void put(struct particles *p, double x, double y, double z, double radius) {
    size_t k = particles_append(p);
    p->state[k] = (struct particle_state){
        .x = {x, y, z}, .radius = radius, .inverse_mass = 1.0 / particles_sphere_mass(radius, 1.0)};
    p->id[k] = (int64_t)k + 1;
}

/* n^3 cells of a lattice, `count` places a cell; `layers` of them along z. */
static struct packing crystal(const double (*place)[3], int count, const double cell[3], int n, int layers) {
    struct packing packing = {particles_with(WITH_SPIN, 1024), n * cell[0]};
    for (int c = 0; c < n * n * layers; c++)
        for (int q = 0; q < count; q++)
            put(packing.particles, (c % n + place[q][0]) * cell[0], (c / n % n + place[q][1]) * cell[1],
                (c / (n * n) + place[q][2]) * cell[2], 1.0);
    return packing;
}

static const double corner[1][3] = {{0, 0, 0}};
static const double body[2][3] = {{0, 0, 0}, {0.5, 0.5, 0.5}};
static const double faces[4][3] = {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
static const double close[4][3] = {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 1 / 6.0, 0.5}, {0, 2 / 3.0, 0.5}};

enum { SC, BCC, FCC, HCP, HEXAGONAL, RANDOM, RATIO, PACKINGS };

/* One of radius 50 under some hundred of radius 1, among which many touch each other. */
static struct packing coated(void) {
    struct packing packing = {particles_with(WITH_SPIN, 512), 0.0};
    put(packing.particles, 0, 0, 0, 50);
    for (int k = 0; k < 300; k++) { /* a spiral from the pole on */
        double z = 1 - 0.0004 * k, turn = 2.399963 * k, r = sqrt(1 - z * z);
        put(packing.particles, 50.99 * r * cos(turn), 50.99 * r * sin(turn), 50.99 * z, 1);
    }
    return packing;
}

static struct packing packing_make(int which, double overlap) {
    const double d = 2 - overlap;
    switch (which) {
    case SC:
        return crystal(corner, 1, (double[3]){d, d, d}, 6, 6);
    case BCC:
        return crystal(body, 2, (double[3]){2 * d / sqrt(3), 2 * d / sqrt(3), 2 * d / sqrt(3)}, 4, 4);
    case FCC:
        return crystal(faces, 4, (double[3]){d * sqrt(2), d * sqrt(2), d * sqrt(2)}, 4, 4);
    case HCP: {
        struct packing open = crystal(close, 4, (double[3]){d, d * sqrt(3), d * sqrt(8 / 3.0)}, 5, 3);
        open.edge = 0;
        return open;
    }
    case HEXAGONAL: {
        struct packing open = crystal(close, 2, (double[3]){d, d * sqrt(3), 0}, 10, 1);
        open.edge = 0;
        return open;
    }
    case RANDOM: {
        struct law law = {.materials = 1, .spin = true};
        return (struct packing){cloud(&law, COUNT, edge), edge};
    }
    default:
        return coated();
    }
}

/* Which springs: friction, rolling resistance, Hertz's law, damping. */
struct choice {
    enum law_normal normal;
    bool friction, rolling;
    double restitution;
};
static const struct choice choices[] = {{LAW_HOOKE, false, false, 1.0}, {LAW_HOOKE, true, false, 1.0},
                                        {LAW_HOOKE, true, true, 1.0},   {LAW_HERTZ, false, false, 1.0},
                                        {LAW_HERTZ, true, false, 1.0},  {LAW_HERTZ, true, true, 1.0},
                                        {LAW_HOOKE, true, false, 0.3},  {LAW_HERTZ, true, true, 0.1}};

static struct law law_of(const struct choice *choice) {
    static struct law_pair pair[2][2];
    const struct law_material m = {"m", 1.0, 1e4, 0.3};
    struct law_options o = law_options_default();
    struct law law;
    struct error error = {0};
    o.normal = choice->normal;
    o.tangential = choice->friction ? LAW_TANGENTIAL_HISTORY : LAW_FRICTIONLESS;
    o.rolling = choice->rolling ? LAW_ROLLING_SPRING : LAW_ROLLING_NONE;
    pair[0][0] = (struct law_pair){.restitution = choice->restitution,
                                   .friction = 0.5,
                                   .rolling_friction = choice->rolling ? 0.1 : 0.0,
                                   .k_n = 7000.0,
                                   .k_t = 2000.0};
    if (!law_prepare(&law, &o, 1, &m, pair[0], &error))
        fail_msg("%s", error.text);
    return law;
}

/* One contact for the power iteration. */
struct bond {
    size_t i, j;
    struct law_vector n;
    double a_n, a_t, a_r; /* h^2 k + 2 h c */
    double radius;
};

/* All contacts, found by looking at all pairs and images. */
static size_t bonds_find(const struct packing *packing, const struct law *law, double h, struct bond *bond) {
    const struct particles *p = packing->particles;
    struct box box = {
        .dimension = 3, .edge = {packing->edge, packing->edge, packing->edge}, .periodic = {1, 1, 1}};
    double shift[IMAGE_CODES][4];
    size_t count = 0;
    box_image_shifts(&box, shift);
    for (size_t i = 0; i < p->owned; i++)
        for (size_t j = i; j < p->owned; j++)
            for (unsigned code = 0; code < (packing->edge > 0 ? (unsigned)IMAGE_CODES : 1u); code++) {
                const struct particle_state *a = &p->state[i], *b = &p->state[j];
                struct law_vector d = {b->x[0] - a->x[0] + shift[code][0], b->x[1] - a->x[1] + shift[code][1],
                                       b->x[2] - a->x[2] + shift[code][2]};
                double distance = sqrt(law_dot(d, d)), reach = a->radius + b->radius;
                if (distance >= reach || (i == j && code <= image_opposite(code)))
                    continue;
                double radius = a->radius * b->radius / reach;
                struct timestep_springs s = timestep_springs(
                    law, 0, 0, 1 / (a->inverse_mass + b->inverse_mass), radius, reach - distance);
                bond[count++] = (struct bond){.i = i,
                                              .j = j,
                                              .n = law_scale(1 / distance, d),
                                              .a_n = h * h * s.k_n + 2 * h * s.c_n,
                                              .a_t = h * h * s.k_t + 2 * h * s.c_t,
                                              .a_r = h * h * s.k_r + 2 * h * s.c_r,
                                              .radius = radius};
                assert_true(count < HAND_PAIRS);
            }
    return count;
}

/* A displacement and a rotation of each particle. */
struct move {
    struct law_vector u, w;
};

/* to = (inverse of mass and inertia) x (stiffness) x from. */
static void apply(const struct particles *p, const struct bond *bond, size_t bonds, const struct move *from,
                  struct move *to) {
    memset(to, 0, p->owned * sizeof *to);
    for (size_t k = 0; k < bonds; k++) {
        const struct bond *b = &bond[k];
        double ri = p->state[b->i].radius, rj = p->state[b->j].radius;
        struct law_vector du = law_add(from[b->j].u, -1, from[b->i].u);
        struct law_vector turn = law_add(law_scale(ri, from[b->i].w), rj, from[b->j].w);
        struct law_vector slip = law_add(law_project(du, b->n), -1, law_cross(turn, b->n));
        struct law_vector roll =
            law_scale(b->radius, law_project(law_add(from[b->j].w, -1, from[b->i].w), b->n));
        struct law_vector force = law_add(law_scale(b->a_n * law_dot(du, b->n), b->n), b->a_t, slip);
        struct law_vector moment = law_scale(-b->a_t, law_cross(b->n, slip));
        to[b->j].u = law_add(to[b->j].u, 1, force);
        to[b->i].u = law_add(to[b->i].u, -1, force);
        to[b->j].w = law_add(law_add(to[b->j].w, rj, moment), b->radius * b->a_r, roll);
        to[b->i].w = law_add(law_add(to[b->i].w, ri, moment), -b->radius * b->a_r, roll);
    }
    for (size_t k = 0; k < p->owned; k++) {
        double r = p->state[k].radius, m = p->state[k].inverse_mass;
        to[k].u = law_scale(m, to[k].u);
        to[k].w = law_scale(m / (0.4 * r * r), to[k].w);
    }
}

static double product(const struct particles *p, const struct move *a, const struct move *b) {
    double sum = 0.0;
    for (size_t k = 0; k < p->owned; k++) {
        double r = p->state[k].radius;
        sum += (law_dot(a[k].u, b[k].u) + 0.4 * r * r * law_dot(a[k].w, b[k].w)) / p->state[k].inverse_mass;
    }
    return sum;
}

/* The largest eigenvalue, from below. */
static double eigenvalue(const struct packing *packing, const struct bond *bond, size_t bonds) {
    static struct move v[1024], next[1024];
    const struct particles *p = packing->particles;
    double value = 0.0;
    for (size_t k = 0; k < p->owned; k++) {
        struct random_sequence r = random_sequence(3, RANDOM_TEST, k);
        v[k].u = (struct law_vector){random_normal(&r), random_normal(&r), random_normal(&r)};
        v[k].w = (struct law_vector){random_normal(&r), random_normal(&r), random_normal(&r)};
    }
    for (int n = 0; n < ITERATIONS; n++) {
        double size = 1 / sqrt(product(p, v, v));
        for (size_t k = 0; k < p->owned; k++)
            v[k] = (struct move){law_scale(size, v[k].u), law_scale(size, v[k].w)};
        apply(p, bond, bonds, v, next);
        value = product(p, v, next);
        memcpy(v, next, p->owned * sizeof *v);
    }
    return value;
}

static double bound(const struct packing *packing, const struct law *law, double h, int threads,
                    double busy) {
    struct pairlist list;
    struct stability stability;
    hand_make(&list, packing->particles,
              &(struct hand_options){.threads = threads, .margin = 0.1, .edge = packing->edge, .busy = busy});
    struct force_context context = {.particles = packing->particles, .list = &list, .law = law};
    stability_create(&stability, &context, h);
    stability_pairs(&stability, &context);
    stability_solve(&stability, packing->particles);
    double worst = stability_worst(&stability, &context);
    stability_free(&stability);
    hand_free(&list);
    return worst;
}

/* How far below the bound the largest eigenvalue may lie: without rolling resistance the bound is sharp for
 * sc, bcc and, where k_t is near k_n, fcc. */
static const double least[PACKINGS] = {[SC] = 0.79,        [BCC] = 0.79,    [FCC] = 0.79,  [HCP] = 0.74,
                                       [HEXAGONAL] = 0.79, [RANDOM] = 0.57, [RATIO] = 0.64};
static const char *const names[PACKINGS] = {"sc", "bcc", "fcc", "hcp", "hexagonal", "random", "ratio 50"};

/* The step is the true limit where the eigenvalue is 4; below it where the bound is. */
static void test_bound_holds(void **state) {
    (void)state;
    struct bond *bond = memory_allocate(HAND_PAIRS, sizeof *bond, "bonds");
    for (int which = 0; which < PACKINGS; which++)
        for (size_t k = 0; k < sizeof choices / sizeof choices[0]; k++) {
            struct packing packing = packing_make(which, k % 2 ? 0.001 : 0.1);
            OWN_LAW law = law_of(&choices[k]);
            double h = 0.01, worst = bound(&packing, &law, h, 1, 0.0);
            double value = eigenvalue(&packing, bond, bonds_find(&packing, &law, h, bond));
            print_message("%-10s choice %zu: eigenvalue %.4g of the bound, step %.4g of the true limit\n",
                          names[which], k, value / worst, sqrt(value / worst));
            assert_true(value <= worst * (1 + 1e-6));
            assert_true(value >= least[which] * worst);
            particles_destroy(&packing.particles);
        }
    memory_free(bond);
}

/* Close-packed spheres turn all alike: 40 k_t / m. */
static void test_spin_of_fcc(void **state) {
    (void)state;
    struct packing packing = packing_make(FCC, 0.001);
    OWN_LAW law = law_of(&choices[1]);
    law.pair[law_place_of(law.materials, 0, 0)].k_n =
        law.pair[law_place_of(law.materials, 0, 0)].k_t; /* then that mode is the fastest */
    double mass = particles_sphere_mass(1.0, 1.0), k_t = law.pair[law_place_of(law.materials, 0, 0)].k_t;
    assert_near(bound(&packing, &law, 1.0, 1, 0.0) * mass / k_t, 40.0, 1e-6);
    particles_destroy(&packing.particles);
}

/* Threads, and particles with slots, change no bit. */
static void test_layouts(void **state) {
    (void)state;
    struct packing packing = packing_make(RANDOM, 0.0);
    for (size_t k = 0; k < sizeof choices / sizeof choices[0]; k++) {
        OWN_LAW law = law_of(&choices[k]);
        double one = bound(&packing, &law, 0.01, 1, 0.0);
        assert_true(one > 0.0);
        for (int threads = 2; threads <= HAND_THREADS; threads++) {
            assert_true(bound(&packing, &law, 0.01, threads, 0.0) == one);
            assert_true(bound(&packing, &law, 0.01, threads, 1.0) == one);
        }
    }
    particles_destroy(&packing.particles);
}

/* Springs and dampers are the slopes of the law's force. */
static void test_springs(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof choices / sizeof choices[0]; k++) {
        OWN_LAW law = law_of(&choices[k]);
        struct law_case kind = law_case_of(&law.options, false);
        struct law_contact in = {.overlap = 0.02,
                                 .mass = 1.3,
                                 .radius = 0.6,
                                 .normal = {1, 0, 0},
                                 .half_normal = {1, 0, 0},
                                 .coefficients = law.pair[law_place_of(law.materials, 0, 0)]};
        struct timestep_springs s = timestep_springs(&law, 0, 0, in.mass, in.radius, in.overlap);
        struct law_step step = law_step_of(&law.options, 0.0);
        double small = 1e-6;
        in.coefficients.friction = 1e9;
        in.coefficients.rolling_friction = choices[k].rolling ? 1e9 : 0.0;
        double force = law_respond(kind, step, &in).force.x;
        in.overlap += small;
        assert_near((law_respond(kind, step, &in).force.x - force) / small / s.k_n, 1.0, 1e-3);
        in.overlap -= small;
        in.velocity.x = small;
        assert_near((force - law_respond(kind, step, &in).force.x) / small, s.c_n, 1e-3 * s.c_n + 1e-6);
        in.velocity.x = 0;
        if (!choices[k].friction) {
            assert_true(s.k_t == 0.0 && s.k_r == 0.0);
            continue;
        }
        in.spring.y = in.roll.z = small;
        struct law_response out = law_respond(kind, step, &in);
        assert_near(-out.force.y / small / s.k_t, 1.0, 1e-6);
        assert_near(-out.rolling.z / small, s.k_r * in.radius, 1e-6 * s.k_t);
    }
}

static void test_eigenvalue(void **state) {
    (void)state;
    const double tensor[6] = {2, 3, 4, 1, 0, 0}; /* 2.5 +- sqrt(0.25 + 1), 4 */
    assert_near(stability_eigenvalue(tensor, STABILITY_PUSH), 4.0, 1e-9);
    const double wall[15] = {3.5, 1, 1, 0, 0, 0, 0, 2.5, 2.5, 0, 0, 0, 0, 0, 0};
    assert_near(stability_eigenvalue(wall, STABILITY_SUMS), 3.5, 1e-12);
    const double both[15] = {1, 1, 1, 0, 0, 0, 2.5, 2.5, 2.5, 0, 0, 0, sqrt(2.5), 0, 0};
    assert_near(stability_eigenvalue(both, STABILITY_SUMS), 3.5, 1e-12);
    const double diagonal[6] = {1, 7, 2, 0, 0, 0};
    assert_near(stability_eigenvalue(diagonal, STABILITY_PUSH), 7.0, 1e-9);
}

TEST_MAIN(stability, cmocka_unit_test(test_eigenvalue), cmocka_unit_test(test_springs),
          cmocka_unit_test(test_spin_of_fcc), cmocka_unit_test(test_layouts),
          cmocka_unit_test(test_bound_holds))
