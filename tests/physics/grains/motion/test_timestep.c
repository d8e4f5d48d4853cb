/* SPDX-License-Identifier: BSD-3-Clause */
/* The stable time step against plain simulation of the scheme, and for the published cases. */
#include "tests/test.h"

#include "physics/grains/motion/timestep.h"
#include "tests/own_law.h"
#include <math.h>
#include <string.h>
#include "tests/near.h"

static struct law_pair pair[2][2];

/* Largest |x| late in a leapfrog run of a chain of `n` unit masses, neighbours and both ends joined by
 * springs and dampers that see the velocity of the last half step; it starts with alternating signs. */
static double chain_run(int n, double stiffness, double damping, double dt) {
    double x[16] = {0}, v[16] = {0}, f[16], largest = 0.0;
    for (int i = 0; i < n; i++)
        x[i] = i % 2 ? -1.0 : 1.0;
    for (int step = 0; step < 20000; step++) {
        memset(f, 0, sizeof f);
        for (int i = 0; i <= n; i++) {
            double left = i > 0 ? x[i - 1] : 0.0, right = i < n ? x[i] : 0.0;
            double rate = (i < n ? v[i] : 0.0) - (i > 0 ? v[i - 1] : 0.0);
            double pull = stiffness * (right - left) + damping * rate;
            if (i > 0)
                f[i - 1] += pull;
            if (i < n)
                f[i] -= pull;
        }
        for (int i = 0; i < n; i++) {
            v[i] += dt * f[i];
            x[i] += dt * v[i];
            if (step > 15000 || fabs(x[i]) > 1e9)
                largest = fmax(largest, fabs(x[i]));
        }
        if (largest > 1e9)
            break;
    }
    return largest;
}

/* One mass between two fixed points is a single spring-dashpot: the bound is sharp, from undamped to
 * overdamped. */
static void test_bound_is_sharp(void **state) {
    (void)state;
    const double zeta[] = {0.0, 0.1, 0.5, 1.0, 1.1, 1.6, 10.0, 36.0};
    for (size_t k = 0; k < sizeof zeta / sizeof zeta[0]; k++) {
        double w = 3.0, stiffness = w * w, damping = 2.0 * zeta[k] * w;
        double bound = timestep_bound(stiffness, damping, 1.0);
        assert_near(bound * w, 2.0 * (sqrt(1.0 + zeta[k] * zeta[k]) - zeta[k]), 1e-12);
        assert_true(chain_run(1, 0.5 * stiffness, 0.5 * damping, 0.995 * bound) < 100.0);
        assert_true(chain_run(1, 0.5 * stiffness, 0.5 * damping, 1.005 * bound) > 1e6);
    }
    assert_true(isinf(timestep_bound(0.0, 0.0, 1.0)));
}

/* The limits of spheres of one material and one law. */
static struct timestep_limits limits_for(const struct law *law, const struct law_material *m, int kinds,
                                         const struct timestep_kind *kind, int contacts, double speed) {
    struct timestep_limits limits;
    timestep_limits(&limits, &(struct timestep_input){.law = law,
                                                      .kinds = kinds,
                                                      .kind = kind,
                                                      .material = m,
                                                      .speed_max = speed,
                                                      .contacts = contacts});
    return limits;
}

static struct law prepared(struct law_options options, int materials, const struct law_material *m) {
    struct law law;
    struct error error = {0};
    if (!law_prepare(&law, &options, materials, m, pair[0], &error))
        fail_msg("%s", error.text);
    return law;
}

/* A chain of spheres with two contacts each is the case for which counting contacts is exact (in the
 * long-chain limit). */
static void test_chain(void **state) {
    (void)state;
    const struct law_material m = {"m", 1.0, 0.0, 0.0};
    const double damping[] = {0.0, 0.3, 5.0};
    for (int k = 0; k < 3; k++) {
        struct law_options options = law_options_default();
        options.normal = LAW_HOOKE;
        options.damping = LAW_DAMPING_COEFFICIENT;
        options.tangential = LAW_FRICTIONLESS;
        pair[0][0] = (struct law_pair){.k_n = 7.0, .gamma_n = 2.0 * damping[k]}; /* m* = 1/2 */
        OWN_LAW law = prepared(options, 1, &m);
        const struct timestep_kind kind = {
            .radius_min = 1.0, .radius_max = 1.0, .mass_min = 1.0, .body = TIMESTEP_SPHERE};
        struct timestep_limits limits = limits_for(&law, &m, 1, &kind, 2, 0.0);
        assert_near(limits.frequency, sqrt(14.0), 1e-12);
        assert_near(limits.damping_ratio, damping[k] / sqrt(14.0), 1e-12);
        assert_near(limits.contact_time, M_PI / sqrt(14.0), 1e-12);
        assert_true(chain_run(16, 7.0, damping[k], limits.stable) < 100.0);
        assert_true(chain_run(16, 7.0, damping[k], 1.02 * limits.stable) > 1e6);
    }
}

/* Largest stretch of the tangential spring between a sphere (mass 1, radius 1, inertia 2/5) and a wall, and
 * of a rolling one beside it, late in a leapfrog run. */
static double sticking_run(double stiffness, double damping, bool rolling, double dt) {
    double x = 1.0, v = 0.0, angle = 0.5, spin = 0.0, largest = 0.0;
    for (int step = 0; step < 20000 && largest < 1e9; step++) {
        double force = -stiffness * (x + angle) - damping * (v + spin);
        double torque = force - (rolling ? stiffness * angle + damping * spin : 0.0);
        v += dt * force;
        spin += dt * torque / 0.4;
        x += dt * v;
        angle += dt * spin;
        if (step > 15000 || fabs(x + angle) > 1e9)
            largest = fmax(largest, fabs(x + angle));
    }
    return largest;
}

/* With friction the sphere turns as it slips: the tangential mode's mass is m* / 3.5, sharp; with rolling
 * resistance m* / 6 is safe. */
static void test_tangential_mode(void **state) {
    (void)state;
    const struct law_material m = {"m", 1.0, 0.0, 0.0};
    const double damping[] = {0.0, 1.0, 30.0};
    for (int k = 0; k < 3; k++)
        for (int rolling = 0; rolling < 2; rolling++) {
            struct law_options options = law_options_default();
            options.normal = LAW_HOOKE;
            options.damping = LAW_DAMPING_COEFFICIENT;
            options.rolling = rolling ? LAW_ROLLING_SPRING : LAW_ROLLING_NONE;
            pair[0][0] = (struct law_pair){
                .friction = 1.0, .rolling_friction = 1.0, .k_n = 7.0, .k_t = 7.0, .gamma_t = damping[k]};
            OWN_LAW law = prepared(options, 1, &m);
            const struct timestep_kind kind[2] = {{0, false, 1.0, 1.0, 1.0, TIMESTEP_SPHERE, {0, 0, 0}},
                                                  {.wall = true}};
            struct timestep_limits spheres = limits_for(&law, &m, 1, kind, 1, 0.0);
            struct timestep_limits both = limits_for(&law, &m, 2, kind, 1, 0.0);
            /* m* is half a mass, R* half a radius */
            assert_near(spheres.stable, timestep_bound(7.0, 0.5 * damping[k], rolling ? 8.25 : 7.0), 1e-12);
            double bound = timestep_bound(7.0, damping[k], rolling ? 6.0 : 3.5);
            assert_true(both.stable <= bound && both.stable <= spheres.stable);
            assert_true(sticking_run(7.0, damping[k], rolling, 0.995 * bound) < 100.0);
            assert_true(sticking_run(7.0, damping[k], rolling, (rolling ? 1.2 : 1.005) * bound) > 1e6);
        }
}

/* Spheres of radius 1 and 10, Hooke with LAMMPS's coefficients: damping ratios 1.1, 1.6 and 36; its dt is
 * 0.001. */
static void test_bidisperse(void **state) {
    (void)state;
    const struct law_material m[2] = {{"small", 1.0, 0.0, 0.0}, {"large", 1.0, 0.0, 0.0}};
    struct law_options options = law_options_default();
    options.normal = LAW_HOOKE;
    options.damping = LAW_DAMPING_COEFFICIENT;
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++)
            pair[a][b] = (struct law_pair){
                .friction = 0.5, .k_n = 1000.0, .k_t = 1000.0 * 2.0 / 7.0, .gamma_n = 50.0, .gamma_t = 25.0};
    OWN_LAW law = prepared(options, 2, m);
    double mass = 4.0 / 3.0 * M_PI;
    const struct timestep_kind kind[2] = {{0, false, 1.0, 1.0, mass, TIMESTEP_SPHERE, {0, 0, 0}},
                                          {1, false, 10.0, 10.0, 1000.0 * mass, TIMESTEP_SPHERE, {0, 0, 0}}};
    struct timestep_limits small = limits_for(&law, m, 1, kind, 0, 0.0);
    struct timestep_limits large = limits_for(&law, m, 1, kind + 1, 0, 0.0);
    struct timestep_limits both = limits_for(&law, m, 2, kind, 0, 0.0);
    assert_near(small.damping_ratio, 1.144, 1e-3);
    assert_near(large.damping_ratio, 36.18, 1e-2);
    assert_near(both.contact_time, M_PI * sqrt(0.5 * mass / 1000.0), 1e-12);
    assert_true(both.stable <= fmin(small.stable, large.stable));
    assert_true(both.stable > 1e-3 && both.stable < 1e-2);
    /* small against large alone: zeta = 1.6 */
    double c = 50.0 * mass, w = sqrt(1000.0 / mass);
    assert_near(0.5 * c / (mass * w), 1.62, 1e-2);
    assert_true(timestep_bound(1000.0, c, 1.0 / mass) > both.stable);
}

/* The penetration case of Dosta et al. 2024: glass of 1 GPa, d = 2 mm, a steel ball of 20 mm at 5 m/s, steel
 * walls; its dt = 5e-7 s is allowed, and 6 % of the Rayleigh time. */
static void test_penetration(void **state) {
    (void)state;
    const struct law_material m[2] = {{"glass", 2500.0, 1e9, 0.2}, {"steel", 7200.0, 210e9, 0.2}};
    struct law_options options = law_options_default();
    pair[0][0] = (struct law_pair){.restitution = 0.5, .friction = 0.3};
    pair[0][1] = (struct law_pair){.restitution = 0.4, .friction = 0.2};
    pair[1][1] = (struct law_pair){.restitution = 0.6, .friction = 0.5};
    double glass = 4.0 / 3.0 * M_PI * 1e-9 * 2500.0, ball = 4.0 / 3.0 * M_PI * 1e-6 * 7200.0;
    const struct timestep_kind kind[3] = {{0, false, 1e-3, 1e-3, glass, TIMESTEP_SPHERE, {0, 0, 0}},
                                          {1, false, 1e-2, 1e-2, ball, TIMESTEP_SPHERE, {0, 0, 0}},
                                          {.material = 1, .wall = true}};
    for (int equal = 0; equal < 2; equal++) {
        options.tangential_damping_equal = equal;
        OWN_LAW law = prepared(options, 2, m);
        struct timestep_limits limits = limits_for(&law, m, 3, kind, 0, 5.0);
        assert_near(limits.rayleigh / 8.5e-6, 1.0, 0.02);
        assert_true(limits.stable > 5e-7 && limits.stable < 1e-5);
        assert_true(timestep_default_fraction() * limits.stable < limits.contact_time / 20.0);
        /* faster is stiffer; a slower scene is limited by the overlap that is counted with at least */
        assert_true(limits_for(&law, m, 3, kind, 0, 50.0).stable < limits.stable);
        assert_true(limits_for(&law, m, 3, kind, 0, 0.0).stable > limits.stable);
        assert_true(isfinite(limits_for(&law, m, 3, kind, 0, 0.0).stable));
        assert_true(limits_for(&law, m, 3, kind, 8, 5.0).stable < limits.stable);
    }
}

/* Hertz: an impact at the stated speed reaches the overlap whose stiffness is counted. */
static void test_hertz_frequency(void **state) {
    (void)state;
    const struct law_material m = {"glass", 2800.0, 48e9, 0.2};
    struct law_options options = law_options_default();
    options.tangential = LAW_FRICTIONLESS;
    pair[0][0] = (struct law_pair){.restitution = 1.0};
    OWN_LAW law = prepared(options, 1, &m);
    double mass = 4.0 / 3.0 * M_PI * 1e-6 * 2800.0;
    const struct timestep_kind kind = {
        .radius_min = 0.01, .radius_max = 0.01, .mass_min = mass, .body = TIMESTEP_SPHERE};
    struct timestep_limits limits = limits_for(&law, &m, 1, &kind, 1, 20.0);
    double overlap = 274.11e-6, force = 10.697e3; /* Chung and Ooi 2011, test 1 */
    assert_near(limits.frequency / sqrt(1.5 * force / overlap / (0.5 * mass)), 1.0, 1e-3);
    assert_near(limits.contact_time / 40.340e-6, 1.0, 1e-3);
    assert_near(limits.stable * limits.frequency, 2.0, 1e-12);
    assert_true(limits.damping_ratio == 0.0);
}

static void test_nothing_to_limit(void **state) {
    (void)state;
    const struct law_material m = {"steel", 7200.0, 210e9, 0.2};
    pair[0][0] = (struct law_pair){.restitution = 1.0};
    OWN_LAW law = prepared(law_options_default(), 1, &m);
    const struct timestep_kind wall = {.wall = true};
    struct timestep_limits limits = limits_for(&law, &m, 1, &wall, 0, 0.0);
    assert_true(isinf(limits.stable) && isinf(limits.contact_time) && limits.rayleigh == 0.0);
}

/* A free wall has a stiffness of its own: of one contact at its softest place, or of as many spheres as lie on it. */
static void test_free_wall(void **state) {
    (void)state;
    const struct law_material m = {"m", 1.0, 0.0, 0.0};
    struct law_options options = law_options_default();
    options.normal = LAW_HOOKE;
    options.damping = LAW_DAMPING_COEFFICIENT;
    options.tangential = LAW_FRICTIONLESS;
    pair[0][0] = (struct law_pair){.k_n = 7.0};
    OWN_LAW law = prepared(options, 1, &m);
    struct timestep_kind kind[2] = {{0, false, 1.0, 1.0, 1.0, TIMESTEP_SPHERE, {0, 0, 0}}, {.wall = true}};
    double local = 2.0 * 7.0;
    assert_near(limits_for(&law, &m, 2, kind, 2, 0.0).stable, 2.0 / sqrt(2.0 * local), 1e-12);
    kind[1].yield = (struct timestep_yield){.one = 3.0, .all = 0.01, .area = 100.0};
    assert_near(limits_for(&law, &m, 2, kind, 2, 0.0).stable, 2.0 / sqrt(local + 3.0 * 7.0), 1e-12);
    kind[1].yield = (struct timestep_yield){.one = 0.5, .all = 0.1, .area = 100.0};
    assert_near(limits_for(&law, &m, 2, kind, 2, 0.0).stable,
                2.0 / sqrt(local + 10.0 / (2.0 * sqrt(3.0)) * 7.0), 1e-12);
    kind[1].yield = (struct timestep_yield){.one = 0.05, .all = 0.01, .area = 10.0};
    assert_near(limits_for(&law, &m, 2, kind, 2, 0.0).stable, 2.0 / sqrt(2.0 * local), 1e-12);
}

TEST_MAIN(timestep, cmocka_unit_test(test_bound_is_sharp), cmocka_unit_test(test_chain),
          cmocka_unit_test(test_tangential_mode), cmocka_unit_test(test_bidisperse),
          cmocka_unit_test(test_penetration), cmocka_unit_test(test_hertz_frequency),
          cmocka_unit_test(test_nothing_to_limit), cmocka_unit_test(test_free_wall))
