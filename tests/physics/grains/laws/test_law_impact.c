/* SPDX-License-Identifier: BSD-3-Clause */
/* Contact laws against closed forms: two-body impacts, sliding and rolling, integrated with the scheme of the
 * program and a fine step. */
#include "tests/test.h"

#include "tests/physics/grains/laws/laws_by_hand.h"
#include "physics/grains/laws/law_restitution.h"

/* Head-on impact in the relative coordinate. */
struct impact {
    double restitution, duration, overlap, force;
};

static struct impact impact_run(const struct law *law, double mass, double radius, double speed, double dt) {
    struct law_step step = law_step_of(&law->options, dt);
    struct law_contact in = {.mass = mass,
                             .radius = radius,
                             .coefficients = law->pair[law_place_of(law->materials, 0, 1)],
                             .normal = {1.0, 0.0, 0.0}};
    struct impact impact = {0};
    double v = -speed, before = 0.0, time = 0.0;
    while (time < 1e6 * dt) {
        before = in.overlap;
        in.overlap -= v * dt;
        time += dt;
        if (in.overlap <= 0.0)
            break;
        in.velocity.x = v;
        struct law_response out = law_respond(law_case_of(&law->options, false), step, &in);
        v += dt * out.force.x / mass;
        impact.overlap = fmax(impact.overlap, in.overlap);
        impact.force = fmax(impact.force, out.force.x);
    }
    impact.restitution = v / speed;
    impact.duration = time - dt * in.overlap / (in.overlap - before);
    return impact;
}

static void test_restitution(void **state) {
    (void)state;
    const double mass[3] = {0.5, 8.0 / 9.0, 1.0}; /* equal, one of twice the radius, a wall */
    const double radius[3] = {0.5, 2.0 / 3.0, 1.0};
    for (int variant = 0; variant < 4; variant++)
        for (int tenth = 0; tenth <= 10; tenth++)
            for (int size = 0; size < 3; size++) {
                struct law_options options = law_options_default();
                options.normal = variant % 2 ? LAW_HERTZ : LAW_HOOKE;
                options.end = variant / 2 ? LAW_END_FORCE : LAW_END_OVERLAP;
                options.tangential = LAW_FRICTIONLESS;
                struct law_pair pair = {.restitution = 0.1 * tenth, .k_n = 1e4};
                OWN_LAW law = law_for(options, glass, pair);
                double w = variant % 2 ? 2e4 : sqrt(1e4 / mass[size]);
                struct impact impact = impact_run(&law, mass[size], radius[size], 1.0, 1e-4 / w);
                assert_near(impact.restitution, pair.restitution, 1e-3);
            }
}

static void test_restitution_ends(void **state) {
    (void)state;
    /* Restitution of a linear spring-dashpot that ends at zero force, for damping ratios: integrated
     * independently */
    const double zeta[5] = {0.1, 0.3, 0.5, 0.8, 1.2};
    const double expected[5] = {0.744079, 0.450975, 0.298436, 0.179783, 0.105210};
    for (int k = 0; k < 5; k++)
        assert_near(law_damping_ratio(expected[k], LAW_END_FORCE), zeta[k], 1e-5);
    assert_near(law_damping_ratio(0.729248, LAW_END_OVERLAP), 0.1, 1e-6);
    assert_near(law_damping_ratio(0.0, LAW_END_OVERLAP), 1.0, 0.0);
    assert_near(law_hertz.damper * law_damping_ratio(0.0, LAW_END_OVERLAP), sqrt(5.0), 1e-12);
    for (int end = 0; end < 2; end++)
        assert_near(law_damping_ratio(1.0, end), 0.0, 0.0);
    /* Hertz with the alpha that gives .2 at zero overlap gives .3249 where it ends at zero force */
    assert_near(law_damping_ratio(0.3249, LAW_END_FORCE), law_damping_ratio(0.2, LAW_END_OVERLAP), 1e-4);
}

/* Chung and Ooi (Granular Matter 13 (2011) 643), tests 1 and 2: elastic impacts. */
static void test_chung_ooi(void **state) {
    (void)state;
    const struct {
        double young, poisson, density, radius, speed;
        bool plane;
        double overlap, force, duration;
    } row[] = {{48e9, 0.20, 2800.0, 0.01, 20.0, false, 274.11e-6, 10.697e3, 40.340e-6},
               {20e9, 0.25, 2500.0, 0.01, 20.0, false, 368.30e-6, 7.1082e3, 54.201e-6},
               {70e9, 0.30, 2699.0, 0.1, 0.2, true, 49.737e-6, 11.370e3, 731.66e-6},
               {40e9, 0.35, 1800.0, 0.1, 0.2, true, 52.123e-6, 7.2327e3, 767.07e-6}};
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        double other = row[k].plane ? 1000.0 : 1.0;
        const struct law_material m[2] = {{"a", row[k].density, row[k].young, row[k].poisson},
                                          {"b", row[k].density, other * row[k].young, row[k].poisson}};
        struct law_options options = law_options_default();
        OWN_LAW law = law_for(options, m, (struct law_pair){.restitution = 1.0, .friction = 0.35});
        double mass = 4.0 / 3.0 * M_PI * pow(row[k].radius, 3.0) * row[k].density;
        double half = row[k].plane ? 1.0 : 0.5;
        struct impact impact =
            impact_run(&law, half * mass, half * row[k].radius, row[k].speed, 1e-4 * row[k].duration);
        assert_near(impact.overlap / row[k].overlap, 1.0, 1e-3);
        assert_near(impact.force / row[k].force, 1.0, 1e-3);
        assert_near(impact.duration / row[k].duration, 1.0, 1e-3);
        assert_near(impact.restitution, 1.0, 1e-4);
    }
}

/* A sphere over the plane z = 0 under a force, with translation and spin in the plane of x and z. */
struct ball {
    double radius, mass;
    double x, z, vx, vz, w; /* w about y */
    struct law_vector spring, roll;
};

static void ball_step(struct ball *b, const struct law *law, double gx, double gz, double dt) {
    b->x += dt * b->vx;
    b->z += dt * b->vz;
    struct law_vector force = {0}, moment = {0}, rolling = {0};
    double overlap = b->radius - b->z,
           lever = law_lever(law_case_of(&law->options, false), b->radius, overlap);
    if (overlap > 0.0) {
        struct law_contact in = {.overlap = overlap,
                                 .mass = b->mass,
                                 .radius = b->radius,
                                 .normal = {0.0, 0.0, -1.0},
                                 .half_normal = {0.0, 0.0, -1.0},
                                 .velocity = {-b->vx, 0.0, -b->vz},
                                 .surface = {0.0, lever * b->w, 0.0},
                                 .spin = {0.0, -b->w, 0.0},
                                 .spring = b->spring,
                                 .roll = b->roll,
                                 .coefficients = law->pair[law_place_of(law->materials, 0, 1)]};
        struct law_response out =
            law_respond(law_case_of(&law->options, false), law_step_of(&law->options, dt), &in);
        b->spring = out.spring;
        b->roll = out.roll;
        force = out.force;
        moment = out.moment;
        rolling = out.rolling;
    }
    b->vx += dt * (gx - force.x / b->mass);
    b->vz += dt * (gz - force.z / b->mass);
    b->w += dt * (lever * moment.y - rolling.y) / (0.4 * b->mass * b->radius * b->radius);
}

/* Gross sliding (Chung and Ooi, test 4, aluminium oxide): v_t' = v_t - mu (1 + e) v_n, w' = 5/2 mu (1 + e)
 * v_n / r. */
static void test_gross_sliding(void **state) {
    (void)state;
    const double e = 0.98, mu = 0.092, r = 2.5e-3, speed = 3.9;
    const struct law_material m[2] = {{"oxide", 4000.0, 380e9, 0.23}, {"wall", 4000.0, 380e12, 0.23}};
    for (int synchronised = 0; synchronised < 2; synchronised++)
        for (int degrees = 35; degrees <= 85; degrees += 10) {
            struct law_options options = law_options_default();
            options.synchronised = synchronised;
            OWN_LAW law = law_for(options, m, (struct law_pair){.restitution = e, .friction = mu});
            double vn = speed * cos(degrees * M_PI / 180.0), vt = speed * sin(degrees * M_PI / 180.0);
            struct ball b = {
                .radius = r, .mass = 4.0 / 3.0 * M_PI * r * r * r * 4000.0, .z = r, .vx = vt, .vz = -vn};
            do
                ball_step(&b, &law, 0.0, 0.0, 2e-9);
            while (b.z < r);
            assert_near(b.vz / vn, e, 1e-3);
            assert_near((vt - b.vx) / (mu * (1.0 + e) * vn), 1.0, 5e-3);
            assert_near(b.w * r / (2.5 * mu * (1.0 + e) * vn), 1.0, 5e-3);
        }
}

/* An impact that slides throughout: Coulomb's impulse where the contact ends at zero force (the default), and
 * more by law_end_friction where it ends at zero overlap, as the damper pulls; the restitution is that asked
 * for in both. */
static void test_end_and_friction(void **state) {
    (void)state;
    const double mu = 0.1, tangential = 10.0;
    for (int hertz = 0; hertz < 2; hertz++)
        for (int end = 0; end < 3; end++)
            for (int tenth = 1; tenth < 10; tenth += 2) {
                double e = 0.1 * tenth,
                       share = law_end_friction(e, end == 1 ? LAW_END_OVERLAP : LAW_END_FORCE);
                struct law_options options = law_options_default();
                options.normal = hertz ? LAW_HERTZ : LAW_HOOKE;
                if (end > 0)
                    options.end = end == 1 ? LAW_END_OVERLAP : LAW_END_FORCE;
                struct law law =
                    law_for(options, glass,
                            (struct law_pair){.restitution = e, .friction = mu, .k_n = 1e4, .k_t = 1e4});
                struct ball b = {.radius = 0.5, .mass = 2.0, .z = 0.5, .vx = tangential, .vz = -1.0};
                double time = M_PI * (hertz ? 1e-4 : sqrt(2.0 / 1e4));
                do
                    ball_step(&b, &law, 0.0, 0.0, 1e-4 * time);
                while (b.z < b.radius);
                assert_near(b.vz, e, 1e-3);
                assert_near((tangential - b.vx) / (mu * (1.0 + e)), 1.0 + share, 2e-3);
            }
    assert_near(law_end_friction(0.5, LAW_END_OVERLAP), 0.067, 5e-4);
    assert_near(law_end_friction(1.0, LAW_END_OVERLAP), 0.0, 1e-15);
}

/* Lets a ball with speed u slide on a plane until `time`. */
static struct ball ball_on_plane(const struct law *law, double u, double w, double gx, double time) {
    const double g = 10.0, k = 1e4;
    struct ball b = {.radius = 0.5, .mass = 2.0, .vx = u, .w = w};
    b.z = b.radius - b.mass * g / k;
    for (long n = 0; n < lround(time * 1e4); n++)
        ball_step(&b, law, gx, -g, 1e-4);
    return b;
}

static struct law hooke_law(double friction, double rolling) {
    struct law_options options = law_options_default();
    options.normal = LAW_HOOKE;
    options.rolling = rolling > 0.0 ? LAW_ROLLING_SPRING : LAW_ROLLING_NONE;
    return law_for(options, glass,
                   (struct law_pair){.restitution = 0.5,
                                     .friction = friction,
                                     .rolling_friction = rolling,
                                     .k_n = 1e4,
                                     .k_t = 1e4 * 2.0 / 7.0});
}

/* Sliding turns into rolling, u = l w with the lever l, at 5/7 of the speed (more exactly: 1 - 1 / (1 + 5/2
 * (l / r)^2)); before: u = u0 - mu g t, w = 5/2 mu g t l / r^2. */
static void test_sliding_to_rolling(void **state) {
    (void)state;
    OWN_LAW law = hooke_law(0.3, 0.0);
    struct ball b = ball_on_plane(&law, 7.0, 0.0, 0.0, 0.4);
    assert_near(b.vx, 7.0 - 0.3 * 10.0 * 0.4, 5e-3);
    assert_near(b.w * b.radius, 2.5 * 0.3 * 10.0 * 0.4, 1e-2);
    double share = 1.0 - 0.5 * 2.0 * 10.0 / 1e4 / 0.5; /* lever over radius */
    double rolling = 7.0 - 7.0 / (1.0 + 2.5 * share * share);
    b = ball_on_plane(&law, 7.0, 0.0, 0.0, 3.0);
    assert_near(b.vx, rolling, 1e-4);
    assert_near(b.w * b.radius * share, rolling, 1e-4);
}

/* Rolling resistance: a rolling ball loses 5/7 mu_r g; on an incline it gains 5/7 (g_x - mu_r g), and stays
 * where that is negative. */
static void test_rolling_resistance(void **state) {
    (void)state;
    OWN_LAW law = hooke_law(0.5, 0.05);
    struct ball b = ball_on_plane(&law, 2.0, 4.0, 0.0, 2.0);
    assert_near(b.vx, 2.0 - 5.0 / 7.0 * 0.05 * 10.0 * 2.0, 5e-3);
    b = ball_on_plane(&law, 0.0, 0.0, 2.0, 1.0);
    assert_near(b.vx, 5.0 / 7.0 * (2.0 - 0.05 * 10.0), 1e-2);
    b = ball_on_plane(&law, 0.0, 0.0, 0.4, 3.0);
    assert_near(b.vx, 0.0, 1e-3);
}

TEST_MAIN(law_impact, cmocka_unit_test(test_restitution), cmocka_unit_test(test_restitution_ends),
          cmocka_unit_test(test_chung_ooi), cmocka_unit_test(test_gross_sliding),
          cmocka_unit_test(test_end_and_friction), cmocka_unit_test(test_sliding_to_rolling),
          cmocka_unit_test(test_rolling_resistance))
