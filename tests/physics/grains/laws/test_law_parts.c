/* SPDX-License-Identifier: BSD-3-Clause */
/* Parts of laws: closed forms of cohesion, forces against energies, symmetry, combinations. */
#include "tests/test.h"

#include "physics/grains/laws/law_general.h"
#include "tests/physics/grains/laws/law_parts_by_hand.h"

/* Forces are slopes of energies, tangents slopes of forces, at touch and across gaps, for spheres and a wall. */
static void test_energies(void **state) {
    (void)state;
    struct random_sequence r = random_sequence(1, RANDOM_TEST, 0);
    struct law_options o = law_options_default();
    int tried = 0;
    for (o.normal = (enum law_normal)0, o.cohesion = LAW_COHESION_NONE; next_cohesion(&o);) {
        OWN_LAW law = law_of(o, sticky);
        if (law.memory.past >= 0) /* plastic: test_law_motion.c */
            continue;
        for (int trial = 0; trial < 400; trial++) {
            double ri = 0.5 + random_uniform(&r), rj = trial % 5 ? 0.5 + random_uniform(&r) : INFINITY;
            struct law_surfaces s = surfaces_of(&law, ri, rj);
            double range = law_cohesion_range(&o, &s), h = 1e-7;
            double overlap = -range + (0.03 + range) * random_uniform(&r);
            if (fabs(overlap) < 1e-5 || fabs(overlap + sticky.cohesion_van_der_waals.gap_least) < 1e-5 ||
                overlap < 1e-5 - range)
                continue;
            struct law_grip at = grip_of(&o, &s, overlap, true);
            struct law_grip up = grip_of(&o, &s, overlap + h, true),
                            down = grip_of(&o, &s, overlap - h, true);
            double scale = fabs(at.force) + fabs(at.tangent) * 1e-3 + 1e-3;
            if (!at.interacts)
                continue;
            assert_near((up.energy - down.energy) / (2.0 * h), at.force, 2e-4 * scale);
            if (overlap > 1e-3 - range)
                assert_near((up.force - down.force) / (2.0 * h), at.tangent, 1e-2 * (fabs(at.tangent) + 1.0));
            tried++;
        }
    }
    assert_true(tried > 2000);
}

/* JKR: a solves the overlap's equation; largest pull 3/2 pi W R*, W = 2 gamma, and both ends. */
static void test_jkr(void **state) {
    (void)state;
    const double modulus = 3e6, gamma = 0.7, radius = 0.3, work = 2.0 * gamma;
    double s = sqrt(2.0 * M_PI * work / modulus), pull = 0.0, where = 0.0;
    double end = -law_jkr_end_gap(s, radius, LAW_JKR_END_DISTANCE);
    assert_near(end / (-0.75 * cbrt(M_PI * M_PI * work * work * radius / (modulus * modulus))), 1.0, 1e-12);
    for (int k = 1; k <= 20000; k++) {
        double overlap = end + (0.01 - end) * k / 20000.0;
        double a = law_jkr_radius(modulus, gamma, radius, overlap);
        double force = law_jkr_at(modulus, gamma, radius, a).force;
        assert_near(a * a / radius - s * sqrt(a), overlap, 1e-11);
        where = force < pull ? overlap : where;
        pull = fmin(pull, force);
    }
    assert_near(pull / (-1.5 * M_PI * work * radius), 1.0, 2e-6);
    assert_near(where, -law_jkr_end_gap(s, radius, LAW_JKR_END_FORCE), 2.0 * 0.011 / 20000.0);
    double a = law_jkr_end_radius(modulus, gamma, radius, LAW_JKR_END_DISTANCE);
    assert_near(law_jkr_at(modulus, gamma, radius, a).force / pull, 5.0 / 9.0, 2e-6);
    assert_near(a * a / radius - s * sqrt(a), end, 1e-14);
    /* without surface energy: Hertz */
    a = law_jkr_radius(modulus, 1e-12, radius, 0.01);
    assert_near(law_jkr_at(modulus, 1e-12, radius, a).force / (4.0 / 3.0 * modulus * sqrt(radius) * 1e-3),
                1.0, 1e-4);
}

/* JKR over 24 orders of magnitude of the overlap: the root solves the equation, without surface energy that of Hertz, and the end
 * without a root is that with one. */
static void test_jkr_digits(void **state) {
    (void)state;
    const double modulus = 2e7, radius = 1e-4;
    for (double gamma = 1e-9; gamma < 1e3; gamma *= 10.0) {
        double s = law_jkr_length(modulus, gamma);
        for (double d = 1e-16; d < 1e8; d *= 3.7) {
            double x = law_jkr_root(s, radius, d), rise = x * x * x * x / radius;
            assert_near((d + s * x) / rise, 1.0, 4e-15);
        }
        for (int end = 0; end < 2; end++) {
            double last = -law_jkr_end_gap(s, radius, (enum law_jkr_end)end);
            assert_true(law_jkr_holds(s, radius, last * (1.0 - 1e-14), (enum law_jkr_end)end));
            assert_false(law_jkr_holds(s, radius, last * (1.0 + 1e-14), (enum law_jkr_end)end));
        }
    }
    for (double d = 1e-16; d < 1e8; d *= 3.7)
        assert_near(law_jkr_radius(modulus, 0.0, radius, d) / sqrt(radius * d), 1.0, 2e-15);
    assert_true(law_jkr_radius(modulus, 0.0, radius, 0.0) == 0.0);
}

/* DMT, capillary bridge and van der Waals at chosen places. */
static void test_pulls(void **state) {
    (void)state;
    struct law_options o = law_options_default();
    o.cohesion = LAW_COHESION_DMT;
    OWN_LAW law = law_of(o, sticky);
    struct law_surfaces s = surfaces_of(&law, 0.5, 1.0);
    double work = 2.0 * sticky.cohesion_dmt.surface_energy;
    assert_near(grip_of(&o, &s, 1e-14, true).force, -2.0 * M_PI * work / 3.0, 1e-12);
    assert_false(grip_of(&o, &s, -1e-14, true).interacts);

    o.cohesion = LAW_COHESION_CAPILLARY;
    law = law_of(o, sticky);
    s = surfaces_of(&law, 0.5, 1.0);
    double most = 4.0 * M_PI / 3.0 * 0.1 * cos(0.4), rupture = (1.0 + 0.2) * 0.1,
           reduced = sqrt(2.0 / 3.0 / 1e-3);
    assert_near(law_cohesion_range(&o, &s), rupture, 1e-15);
    assert_near(grip_of(&o, &s, -1e-15, true).force, -most, 1e-12);
    double at = 0.07 * reduced;
    assert_near(grip_of(&o, &s, -0.07, true).force, -most / (1.0 + 1.05 * at + 2.5 * at * at), 1e-12);
    assert_true(grip_of(&o, &s, -rupture * (1.0 - 1e-12), true).interacts);
    assert_false(grip_of(&o, &s, -rupture, true).interacts);
    assert_false(grip_of(&o, &s, -1e-9, false).interacts); /* no bridge yet */
    assert_near(grip_of(&o, &s, -rupture * (1.0 - 1e-12), true).energy, 0.0, 1e-9);

    o.cohesion = LAW_COHESION_VAN_DER_WAALS;
    law = law_of(o, sticky);
    s = surfaces_of(&law, 0.5, INFINITY);
    assert_near(grip_of(&o, &s, -0.01, false).force, -1e-3 * 0.5 / (6.0 * 1e-4), 1e-12);
    assert_near(grip_of(&o, &s, -1e-5, false).force, -1e-3 * 0.5 / (6.0 * 1e-6), 1e-10);
    assert_false(grip_of(&o, &s, -0.05, true).interacts);

    o.cohesion = LAW_COHESION_SJKR; /* the area of the circle where spheres intersect, and that of a wall */
    law = law_of(o, sticky);
    s = surfaces_of(&law, 0.5, 1.0);
    double distance = 1.48, from = (distance * distance + 0.25 - 1.0) / (2.0 * distance);
    assert_near(law_cohesion_pull(o.cohesion, &s, 0.02, true).force / (1e4 * M_PI * (0.25 - from * from)),
                1.0, 1e-11);
    s = surfaces_of(&law, 0.5, INFINITY);
    assert_near(law_cohesion_pull(o.cohesion, &s, 0.02, true).force / (1e4 * M_PI * (0.25 - 0.48 * 0.48)),
                1.0, 1e-11);
}

static void assert_opposite(struct law_vector a, struct law_vector b) {
    assert_true(a.x == -b.x && a.y == -b.y && a.z == -b.z);
}

/* All combinations, seen from both sides: opposite results to the last bit; vectors of the history change sign,
 * numbers do not. */
static void test_mirror(void **state) {
    (void)state;
    struct random_sequence r = random_sequence(2, RANDOM_TEST, 0);
    for (int k = 0; k < OPTIONS; k++) {
        OWN_LAW law = law_of(options_of(k), sticky);
        struct law_step step = law_step_of(&law.options, 1e-3);
        for (int trial = 0; trial < 10; trial++) {
            struct law_general in = random_contact(&law, &r), back = in;
            struct law_vector *odd[] = {&back.contact.normal, &back.contact.half_normal,
                                        &back.contact.velocity, &back.contact.spin};
            for (size_t v = 0; v < sizeof odd / sizeof odd[0]; v++)
                *odd[v] = law_scale(-1.0, *odd[v]);
            back.radius[0] = in.radius[1];
            back.radius[1] = in.radius[0];
            for (int c = 0; c < law.history_odd; c++)
                back.value[c] = -back.value[c];
            struct law_response a, b;
            bool acts = law_general_respond(&law, step, &in, &a);
            assert_true(acts == law_general_respond(&law, step, &back, &b));
            assert_opposite(a.force, b.force);
            assert_opposite(a.rolling, b.rolling);
            assert_opposite(a.moment, law_scale(-1.0, b.moment));
            assert_true(a.normal_energy == b.normal_energy && a.taken == b.taken);
            for (int c = 0; c < law.history_components; c++)
                assert_true(in.value[c] == (c < law.history_odd ? -back.value[c] : back.value[c]));
        }
    }
}

/* A contact that sticks holds up to the static limit; once it slides, the kinetic one counts until the force
 * falls below it. */
static void test_static_friction(void **state) {
    (void)state;
    struct law_options o = law_options_default();
    o.normal = LAW_HOOKE;
    o.tangential_damping_ratio = 0.0;
    o.synchronised = false;
    struct law_extra extra = {.static_friction = 0.8};
    OWN_LAW law = law_of(o, extra);
    assert_true(law.general && law.history_components == 4);
    double normal = 1e5 * 1e-3, most = 0.0, dt = 1e-4;
    struct law_general in = {.extra = &law.extra[law_place_of(law.materials, 0, 1)], .radius = {1.0, 1.0}};
    in.contact = (struct law_contact){.overlap = 1e-3,
                                      .mass = 1.0,
                                      .radius = 0.5,
                                      .normal = {1.0, 0.0, 0.0},
                                      .velocity = {0.0, 1.0, 0.0},
                                      .coefficients = law.pair[law_place_of(law.materials, 0, 1)]};
    double last = 0.0;
    for (int k = 0; k < 100; k++) {
        struct law_response out;
        law_general_respond(&law, law_step_of(&o, dt), &in, &out);
        last = -out.force.y;
        most = fmax(most, last);
    }
    assert_near(most / normal, 0.8, 3e4 * dt / normal);
    assert_near(last / normal, 0.4, 1e-12);
    in.contact.velocity.y = -1.0;
    struct law_response out;
    law_general_respond(&law, law_step_of(&o, dt), &in, &out);
    assert_true(in.value[law.memory.slides] == 0.0);
}

/* epsd: a damper below the limit, from the inertia against rolling of two spheres of one density. */
static void test_epsd(void **state) {
    (void)state;
    struct law_options o = law_options_default();
    o.normal = LAW_HOOKE;
    o.rolling = LAW_ROLLING_EPSD;
    o.synchronised = false;
    OWN_LAW law = law_of(o, sticky);
    const double a = 0.5, b = 2.0, ma = a * a * a, mb = b * b * b, r = a * b / (a + b),
                 mass = ma * mb / (ma + mb);
    struct law_general in = {.extra = &law.extra[law_place_of(law.materials, 0, 1)], .radius = {a, b}};
    in.contact = (struct law_contact){.overlap = 1e-3,
                                      .mass = mass,
                                      .radius = r,
                                      .normal = {1.0, 0.0, 0.0},
                                      .spin = {0.0, 1e-6, 0.0},
                                      .coefficients = law.pair[law_place_of(law.materials, 0, 1)]};
    struct law_response out;
    law_general_respond(&law, law_step_of(&o, 0.0), &in, &out);
    double k = 2.25 * 1e5 * 0.2 * 0.2 * r * r,
           inertia = 1.0 / (1.0 / (1.4 * ma * a * a) + 1.0 / (1.4 * mb * b * b));
    assert_near(out.rolling.y / (-2.0 * sticky.rolling_epsd.rolling_damping_ratio * sqrt(inertia * k) * 1e-6),
                1.0, 1e-12);
}

/* The cube root against libm's. */
static void test_root(void **state) {
    (void)state;
    assert_true(law_cbrt(0.0) == 0.0 && law_cbrt(1.0) == 1.0);
    for (double x = 1e-60; x < 1e60; x *= 1.7)
        assert_near(law_cbrt(x) / cbrt(x), 1.0, 5e-16);
}

/* What does not combine is refused, and the message names what does. */
static void test_refused(void **state) {
    (void)state;
    struct law law;
    struct error error = {0};
    struct law_options o = law_options_default();
    static struct law_pair pair[2][2];
    pair[0][0] = (struct law_pair){.restitution = 0.5, .k_n = 1.0, .k_t = 1.0, .extra = sticky};
    o.normal = LAW_HOOKE;
    o.cohesion = LAW_COHESION_JKR;
    assert_false(law_prepare(&law, &o, 1, soft, pair[0], &error));
    assert_non_null(strstr(error.text, "contact.cohesion.law: jkr goes with contact.law hertz"));
    assert_non_null(strstr(error.text, "none, sjkr, capillary, van_der_waals"));
    error = (struct error){0};
    o.cohesion = LAW_COHESION_CAPILLARY;
    pair[0][0].extra.cohesion_capillary.bridge_fraction = 0.1;
    assert_false(law_prepare(&law, &o, 1, soft, pair[0], &error));
    assert_non_null(strstr(error.text, "one of bridge_volume and bridge_fraction"));
    error = (struct error){0};
    o.cohesion = LAW_COHESION_VAN_DER_WAALS;
    pair[0][0].extra.cohesion_van_der_waals.gap_least = 1.0;
    assert_false(law_prepare(&law, &o, 1, soft, pair[0], &error));
    assert_non_null(strstr(error.text, "gap_least is above cut_off"));
}

/* A law without parts keeps its history and its loops. */
static void test_absent(void **state) {
    (void)state;
    OWN_LAW law = law_of(law_options_default(), (struct law_extra){0});
    assert_true(!law.general && law.history_components == 3 && law.history_odd == 3);
    struct law_options o = law_options_default();
    o.rolling = LAW_ROLLING_SPRING;
    law = law_of(o, (struct law_extra){0});
    assert_true(!law.general && law.history_components == 6);
    o.cohesion = LAW_COHESION_JKR;
    o.twisting = LAW_TWISTING_MARSHALL;
    o.tangential = LAW_TANGENTIAL_RESCALE;
    law = law_of(o, sticky);
    assert_true(law.general && law.history_components == 9 && law.history_odd == 6);
    assert_true(law_range(&law, 1.0, 1.0) > 0.0 &&
                law_range(&law, 1.0, INFINITY) > law_range(&law, 1.0, 1.0));
}

TEST_MAIN(law_parts, cmocka_unit_test(test_energies), cmocka_unit_test(test_jkr),
          cmocka_unit_test(test_jkr_digits), cmocka_unit_test(test_pulls), cmocka_unit_test(test_mirror),
          cmocka_unit_test(test_static_friction), cmocka_unit_test(test_refused), cmocka_unit_test(test_epsd),
          cmocka_unit_test(test_root), cmocka_unit_test(test_absent))
