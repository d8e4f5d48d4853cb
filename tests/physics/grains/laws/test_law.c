/* SPDX-License-Identifier: BSD-3-Clause */
/* Contact laws: symmetry, limits, energy, what is refused and what a law needs. */
#include "tests/test.h"

#include "tests/physics/grains/laws/laws_by_hand.h"

/* A vector with components in [-1, 1). */
static struct law_vector random_vector(struct random_sequence *r) {
    double x = 2.0 * random_uniform(r) - 1.0, y = 2.0 * random_uniform(r) - 1.0;
    return (struct law_vector){x, y, 2.0 * random_uniform(r) - 1.0};
}

static struct law_vector unit(struct law_vector a) {
    return law_scale(1.0 / sqrt(law_dot(a, a)), a);
}

static struct law_contact random_contact(struct random_sequence *r, struct law_coefficients c) {
    struct law_contact in = {.overlap = 0.02 * random_uniform(r),
                             .mass = 0.5 + random_uniform(r),
                             .radius = 0.5 + random_uniform(r),
                             .velocity = random_vector(r),
                             .surface = random_vector(r),
                             .spin = random_vector(r),
                             .spring = law_scale(0.02, random_vector(r)),
                             .roll = law_scale(0.02, random_vector(r)),
                             .coefficients = c};
    in.normal = unit(random_vector(r));
    in.half_normal = unit(law_add(in.normal, 0.05, random_vector(r)));
    return in;
}

/* The same contact seen from the other side. */
static struct law_contact mirror(struct law_contact in) {
    struct law_vector *odd[] = {&in.normal, &in.half_normal, &in.velocity, &in.spin, &in.spring, &in.roll};
    for (size_t k = 0; k < sizeof odd / sizeof odd[0]; k++)
        *odd[k] = law_scale(-1.0, *odd[k]);
    return in;
}

static void assert_opposite(struct law_vector a, struct law_vector b) {
    assert_true(a.x == -b.x && a.y == -b.y && a.z == -b.z);
}

/* Options number k of all that a law can have. */
static struct law_options options_of(int k) {
    struct law_options o = law_options_default();
    o.damping = k % 2 ? LAW_DAMPING_COEFFICIENT : LAW_DAMPING_RESTITUTION;
    o.end = k / 2 % 2 ? LAW_END_FORCE : LAW_END_OVERLAP;
    o.rolling = k / 4 % 2 ? LAW_ROLLING_SPRING : LAW_ROLLING_NONE;
    o.synchronised = k / 8 % 2;
    o.lammps_history = k / 16 % 2 && !o.synchronised;
    o.sliding = k / 16 % 2 ? LAW_SLIDING_TOTAL : LAW_SLIDING_SERIES;
    o.normal = (enum law_normal)(k / 32);
    return o;
}

enum { OPTIONS = 32 * LAW_SPRING_COUNT };

static struct law random_law(int k) {
    struct law_pair pair = {
        .restitution = 0.6,
        .friction = 0.4,
        .rolling_friction = 0.2,
        .k_n = 1e7,
        .k_t = 3e6,
        .gamma_n = 500.0,
        .gamma_t = 200.0,
        .extra = {.k_2 = 2e7, .yield_pressure = 1e9, .plasticity_ratio = 0.5, .adhesion_exponent = 1.5}};
    return law_for(options_of(k), glass, pair);
}

static void test_mirror(void **state) {
    (void)state;
    struct random_sequence r = random_sequence(1, RANDOM_TEST, 0);
    for (int k = 0; k < OPTIONS; k++) {
        OWN_LAW law = random_law(k);
        struct law_case kind = law_case_of(&law.options, true);
        struct law_step step = law_step_of(&law.options, 1e-3);
        for (int trial = 0; trial < 200; trial++) {
            struct law_contact in = random_contact(&r, law.pair[law_place_of(law.materials, 0, 1)]),
                               back = mirror(in);
            struct law_response a = law_respond(kind, step, &in), b = law_respond(kind, step, &back);
            assert_opposite(a.force, b.force);
            assert_opposite(a.rolling, b.rolling);
            assert_opposite(a.spring, b.spring);
            assert_opposite(a.roll, b.roll);
            assert_opposite(a.moment, law_scale(-1.0, b.moment));
            assert_true(a.normal_energy == b.normal_energy && a.spring_energy == b.spring_energy);
            assert_true(a.taken == b.taken);
        }
    }
}

/* What the springs of a contact hold before the step, by its stiffness now. */
static double held_before(const struct law *law, const struct law_contact *in) {
    struct law_springs springs = law_springs(law->options.normal, &in->coefficients, in->radius, in->overlap);
    double squares = law_dot(in->spring, in->spring);
    if (law->options.tangential == LAW_FRICTIONLESS)
        return 0.0;
    if (law->options.rolling != LAW_ROLLING_NONE)
        squares += law_dot(in->roll, in->roll);
    return 0.5 * springs.tangential * squares;
}

/* The tangential force stays in the tangent plane and within the Coulomb limit, the rolling torque within its
 * own; with the slider in series nothing ever gives energy. */
static void test_limits(void **state) {
    (void)state;
    struct random_sequence r = random_sequence(2, RANDOM_TEST, 0);
    int sliding = 0;
    for (int k = 0; k < OPTIONS; k++) {
        OWN_LAW law = random_law(k);
        struct law_step step = law_step_of(&law.options, 1e-3);
        for (int trial = 0; trial < 200; trial++) {
            struct law_contact in = random_contact(&r, law.pair[law_place_of(law.materials, 0, 1)]);
            if (trial % 2) /* a damper that outweighs the spring in a step */
                in.coefficients.c_t *= 50;
            struct law_response out = law_respond(law_case_of(&law.options, true), step, &in);
            double normal = law_dot(out.force, in.normal);
            struct law_vector tangential = law_project(out.force, in.normal);
            double size = sqrt(law_dot(tangential, tangential)), limit = 0.4 * fabs(normal);
            assert_true(size <= limit * (1.0 + 1e-12) + 1e-9);
            assert_true(fabs(law_dot(out.spring, in.normal)) < 1e-14);
            assert_true(sqrt(law_dot(out.rolling, out.rolling)) <=
                        0.2 * fabs(normal) * in.radius * (1.0 + 1e-12) + 1e-9);
            if (law.options.end == LAW_END_FORCE)
                assert_true(normal >= 0.0);
            if (law.options.sliding == LAW_SLIDING_SERIES)
                assert_true(out.taken - out.spring_energy + held_before(&law, &in) >= -1e-12 * fabs(normal));
            sliding += size > 0.999 * limit;
        }
    }
    assert_true(sliding > 500);
}

/* An empty spring over the limit: no force in LAMMPS's gran/hooke, the limit else. */
static void test_empty_spring(void **state) {
    (void)state;
    OWN_LAW law = random_law(0);
    law.options.synchronised = false;
    struct law_contact in = {.overlap = 1e-3,
                             .mass = 1.0,
                             .radius = 1.0,
                             .normal = {0.0, 0.0, 1.0},
                             .half_normal = {0.0, 0.0, 1.0},
                             .velocity = {1e3, 0.0, 0.0},
                             .coefficients = law.pair[law_place_of(law.materials, 0, 1)]};
    for (int lammps = 0; lammps < 2; lammps++) {
        law.options.lammps_history = lammps;
        struct law_response out =
            law_respond(law_case_of(&law.options, false), law_step_of(&law.options, 0.0), &in);
        assert_near(out.force.z, 1e4, 1e-9);
        assert_near(out.force.x, lammps ? 0.0 : -4e3, 1e-9);
    }
}

/* Two spheres that turn about each other like a rigid body: no slip. The synchronised spring follows through
 * a whole turn; the plain one is dragged along by the difference of half-step velocity and full-step normal.
 */
static void test_rigid_rotation(void **state) {
    (void)state;
    enum { STEPS = 1000 };
    const double overlap = 1e-3, distance = 2.0 - overlap, angle = 2.0 * M_PI / STEPS;
    double error[2];
    for (int synchronised = 0; synchronised < 2; synchronised++) {
        OWN_LAW law = random_law(2);
        law.options.synchronised = synchronised;
        law.pair[law_place_of(law.materials, 0, 1)].c_n = law.pair[law_place_of(law.materials, 0, 1)].c_t =
            0.0;
        law.pair[law_place_of(law.materials, 0, 1)].friction = 1e9;
        struct law_vector spring = {0.0, 1e-4, 2e-4}, old = {1.0, 0.0, 0.0};
        for (int n = 1; n <= STEPS; n++) {
            struct law_vector now = {cos(n * angle), sin(n * angle), 0.0};
            struct law_vector chord = law_scale(distance, law_add(now, -1.0, old));
            struct law_contact in = {.overlap = overlap,
                                     .mass = 0.5,
                                     .radius = 0.5,
                                     .normal = now,
                                     .half_normal = unit(law_add(law_scale(distance, now), -0.5, chord)),
                                     .velocity = chord,
                                     .surface = {0.0, 0.0, distance * 2.0 * sin(0.5 * angle)},
                                     .spring = spring,
                                     .coefficients = law.pair[law_place_of(law.materials, 0, 1)]};
            spring =
                law_respond(law_case_of(&law.options, false), law_step_of(&law.options, 1.0), &in).spring;
            old = now;
        }
        spring = law_add(spring, -1.0, (struct law_vector){0.0, 1e-4, 2e-4});
        error[synchronised] = sqrt(law_dot(spring, spring));
    }
    assert_true(error[1] < 1e-6);
    assert_true(error[0] > 1e-5);
}

/* What dampers and sliding take equals what motion and springs lose. */
static void test_energy_balance(void **state) {
    (void)state;
    for (int k = 0; k < 24; k++) {
        OWN_LAW law = random_law(k);
        law.pair[law_place_of(law.materials, 0, 1)].k_t *= 0.2; /* slides and sticks */
        double dt = 1e-7, mass = 1.0, taken = 0.0, before = 0.5 * (1.0 + 0.09);
        struct law_vector v = {0.3, 0.0, -1.0};
        struct law_contact in = {.mass = mass,
                                 .radius = 1.0,
                                 .normal = {0.0, 0.0, 1.0},
                                 .half_normal = {0.0, 0.0, 1.0},
                                 .coefficients = law.pair[law_place_of(law.materials, 0, 1)]};
        struct law_response out = {0};
        for (int n = 0; n < 2000 && (n == 0 || in.overlap > 0.0); n++) {
            in.overlap -= v.z * dt;
            in.velocity = v;
            out = law_respond(law_case_of(&law.options, true), law_step_of(&law.options, dt), &in);
            in.spring = out.spring;
            taken += out.taken;
            v = law_add(v, dt / mass, out.force);
        }
        double after = 0.5 * law_dot(v, v) + out.normal_energy;
        assert_near(after + taken, before, 1e-3 * before);
        assert_true(taken > 0.0);
    }
}

static void test_refused(void **state) {
    (void)state;
    const struct law_pair good = {.restitution = 0.5, .friction = 0.3, .k_n = 1.0, .k_t = 1.0};
    struct {
        const char *word;
        struct law_options options;
        struct law_material material;
        struct law_pair pair;
    } row[16];
    size_t rows = 0;
#define REFUSED(text, change)                                                                                \
    row[rows].word = text;                                                                                   \
    row[rows].options = law_options_default();                                                               \
    row[rows].material = glass[0];                                                                           \
    row[rows].pair = good;                                                                                   \
    row[rows].change;                                                                                        \
    rows++
    REFUSED("restitution", pair.restitution = 1.1);
    REFUSED("restitution", pair.restitution = NAN);
    REFUSED("friction", pair.friction = -0.1);
    REFUSED("young", material.young = 0.0);
    REFUSED("poisson", material.poisson = 0.6);
    REFUSED("density", material.density = -1.0);
    REFUSED("k_n", options.damping = LAW_DAMPING_COEFFICIENT; row[rows].pair.k_n = 0.0);
    REFUSED("gamma_n", options.damping = LAW_DAMPING_COEFFICIENT; row[rows].pair.gamma_n = -1.0);
    REFUSED("tangential_damping_ratio", options.tangential_damping_ratio = -1.0);
    REFUSED("rolling", options = ((struct law_options){.rolling = LAW_ROLLING_SPRING}));
    REFUSED("velocity_verlet",
            options = ((struct law_options){.lammps_history = true, .synchronised = true}));
    REFUSED("k_n", options = ((struct law_options){.normal = LAW_HOOKE}); row[rows].pair.k_n = 0.0);
    REFUSED("k_t", options.normal = LAW_HOOKE; row[rows].pair.k_t = 0.0);
#undef REFUSED
    for (size_t k = 0; k < rows; k++) {
        struct law law;
        struct error error = {0};
        pairs[0][0] = row[k].pair;
        assert_false(law_prepare(&law, &row[k].options, 1, &row[k].material, pairs[0], &error));
        assert_int_equal(error.kind, ERROR_USER);
        if (strstr(error.text, row[k].word) == NULL)
            fail_msg("case %zu: \"%s\" does not name %s", k, error.text, row[k].word);
    }
}

/* Time and largest overlap of an elastic impact by a law's springs, integrated in small steps. */
static void impact_of(enum law_normal normal, const struct law_coefficients *c, double mass, double radius,
                      double speed, double *overlap, double *duration) {
    double dt = *duration / 200000.0, x = 0.0, v = speed, t = 0.0;
    *overlap = 0.0;
    do {
        v -= 0.5 * dt / mass * law_springs(normal, c, radius, x).force;
        x += dt * v;
        v -= 0.5 * dt / mass * law_springs(normal, c, radius, x).force;
        *overlap = fmax(*overlap, x);
        t += dt;
    } while (x > 0.0);
    *duration = t;
}

/* Each row of the table says of its springs what they do: the energy is the integral of the force, the tangent
 * its derivative, the stiffness its share of the overlap, and impacts reach and last as long as stated. */
static void test_rows(void **state) {
    (void)state;
    struct law_pair pair = {
        .restitution = 0.6,
        .friction = 0.4,
        .k_n = 1e7,
        .k_t = 3e6,
        .extra = {.k_2 = 2e7, .yield_pressure = 1e9, .plasticity_ratio = 0.5, .adhesion_exponent = 1.5}};
    for (int k = 0; k < LAW_SPRING_COUNT; k++) {
        struct law_options options = law_options_default();
        options.normal = (enum law_normal)k;
        OWN_LAW law = law_for(options, glass, pair);
        const struct law_coefficients *c = &law.pair[law_place_of(law.materials, 0, 1)];
        const struct law_form *form = law_row_get(options.normal)->form;
        double radius = 0.7, overlap = 1e-3, small = 1e-4 * overlap;
        struct law_springs s = law_springs(options.normal, c, radius, overlap);
        struct law_springs less = law_springs(options.normal, c, radius, overlap - small);
        struct law_springs more = law_springs(options.normal, c, radius, overlap + small);
        assert_near((more.energy - less.energy) / (2.0 * small) / s.force, 1.0, 1e-7);
        assert_near((more.force - less.force) / (2.0 * small) / s.tangent, 1.0, 1e-7);
        assert_near(s.stiffness * overlap / s.force, 1.0, 1e-14);
        s = law_springs(options.normal, c, radius, 1e-9);
        assert_near(s.tangent / (form->tangent * s.stiffness), 1.0, 1e-12);
        double reached, lasted, mass = 1.3, speed = 0.2;
        double expected = form->impact(c, mass, radius, speed);
        double duration = form->duration(c, mass, radius, expected);
        lasted = duration;
        impact_of(options.normal, c, mass, radius, speed, &reached, &lasted);
        assert_near(reached / expected, 1.0, 1e-6);
        assert_near(lasted / duration, 1.0, 2e-5);
        assert_true(form->linear || k != (int)law_linear());
    }
}

/* LAMMPS's gran/hooke/history and gran/hertz/history, by the formulas of its manual: F_n = f (k_n d - m* gamma_n
 * v_n), F_t = -f (k_t xi + m* gamma_t v_t) with f = 1 or sqrt(d R*), cut to mu |F_n|, where the spring takes
 * what the damper leaves. */
static void test_lammps(void **state) {
    (void)state;
    struct random_sequence r = random_sequence(11, RANDOM_TEST, 0);
    struct law_pair pair = {.friction = 0.4, .k_n = 2e7, .k_t = 5e6, .gamma_n = 300.0, .gamma_t = 100.0};
    int cut = 0;
    for (int k = 0; k < 400; k++) {
        struct law_options options = law_options_default();
        options.normal = k % 2 ? LAW_HERTZ : LAW_HOOKE;
        options.damping = LAW_DAMPING_COEFFICIENT;
        options.end = LAW_END_OVERLAP;
        options.lammps_history = true;
        options.synchronised = false;
        OWN_LAW law = law_for(options, glass, pair);
        struct law_contact in = random_contact(&r, law.pair[law_place_of(law.materials, 0, 1)]);
        struct law_step step = law_step_of(&options, 1e-5);
        struct law_response out = law_respond(law_case_of(&options, false), step, &in);
        double f = k % 2 ? sqrt(in.overlap * in.radius) : 1.0;
        double rate = law_dot(in.velocity, in.normal);
        double normal = f * (pair.k_n * in.overlap - in.mass * pair.gamma_n * rate);
        struct law_vector slip =
            law_add(law_add(in.velocity, -rate, in.normal), -1.0, law_cross(in.surface, in.normal));
        struct law_vector spring = law_add(in.spring, -law_dot(in.spring, in.normal), in.normal);
        spring = law_add(spring, step.dt, slip);
        struct law_vector damper = law_scale(in.mass * pair.gamma_t, slip);
        struct law_vector force = law_scale(-f, law_add(damper, pair.k_t, spring));
        double size = sqrt(law_dot(force, force)), limit = pair.friction * fabs(normal);
        if (size > limit) {
            struct law_vector whole = law_add(spring, 1.0 / pair.k_t, damper);
            spring = law_add(law_scale(limit / size, whole), -1.0 / pair.k_t, damper);
            force = law_scale(limit / size, force);
            cut++;
        }
        force = law_add(force, normal, in.normal);
        assert_near(out.force.x, force.x, 1e-10 * fabs(normal));
        assert_near(out.force.y, force.y, 1e-10 * fabs(normal));
        assert_near(out.force.z, force.z, 1e-10 * fabs(normal));
        struct law_vector left = law_add(out.spring, -1.0, spring);
        assert_near(sqrt(law_dot(left, left)), 0.0, 1e-12);
    }
    assert_true(cut > 40 && cut < 360);
}

/* What a scene needs follows from the options. */
static void test_needs(void **state) {
    (void)state;
    struct law_options options = law_options_default();
    const struct law_pair pair = {.restitution = 0.5, .friction = 0.3, .rolling_friction = 0.1};
    OWN_LAW law = law_for(options, glass, pair);
    assert_true(law.spin && law.history_components == 3 && law_range(&law, 1.0, 2.0) == 0.0);
    /* unlike materials: 1/E* and 1/G* add up, the same from both sides */
    double e = 1.0 / (0.96 / 1e9 + 0.96 / 210e9);
    assert_near(law.pair[law_place_of(law.materials, 0, 1)].k_n / (4.0 / 3.0 * e), 1.0, 1e-14);
    assert_near(law.pair[law_place_of(law.materials, 1, 0)].k_t /
                    (8.0 / (1.8 * 2.4 / 1e9 + 1.8 * 2.4 / 210e9)),
                1.0, 1e-14);
    const struct law_material unlike[2] = {{"rubber", 1100.0, 1e7, 0.45}, {"cork", 240.0, 3e7, 0.05}};
    law = law_for(options, unlike, pair);
    e = 1.0 / ((1.0 - 0.45 * 0.45) / 1e7 + (1.0 - 0.05 * 0.05) / 3e7);
    double g = 1.0 / (1.55 * 2.9 / 1e7 + 1.95 * 2.1 / 3e7);
    for (int a = 0; a < 2; a++) {
        assert_near(law.pair[law_place_of(law.materials, a, 1 - a)].k_n / (4.0 / 3.0 * e), 1.0, 1e-14);
        assert_near(law.pair[law_place_of(law.materials, a, 1 - a)].k_t / (8.0 * g), 1.0, 1e-14);
    }
    options.rolling = LAW_ROLLING_SPRING;
    law = law_for(options, glass, pair);
    assert_int_equal(law.history_components, 6);
    options = law_options_default();
    options.tangential = LAW_FRICTIONLESS;
    law = law_for(options, glass, pair);
    assert_true(!law.spin && law.history_components == 0);
}

TEST_MAIN(law, cmocka_unit_test(test_mirror), cmocka_unit_test(test_limits),
          cmocka_unit_test(test_empty_spring), cmocka_unit_test(test_rigid_rotation),
          cmocka_unit_test(test_energy_balance), cmocka_unit_test(test_refused), cmocka_unit_test(test_rows),
          cmocka_unit_test(test_lammps), cmocka_unit_test(test_needs))
