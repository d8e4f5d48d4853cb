/* Contact laws against closed forms: two-body impacts integrated with the scheme of the program and a fine
 * step. */
#include "contact/law.h"
#include "contact/law_kernel.h"
#include "core/random.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>
#include "near.h"

static struct law_pair pairs[LAW_MATERIALS_MAX][LAW_MATERIALS_MAX];

/* A law for materials m[0] and m[1] with the same coefficients for all pairs. */
static struct law law_for(struct law_options options, const struct law_material m[2], struct law_pair pair) {
    struct law law;
    struct error error = {0};
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++)
            pairs[a][b] = pair;
    if (!law_prepare(&law, &options, 2, m, pairs, &error))
        fail_msg("%s", error.text);
    return law;
}

/* Head-on impact in the relative coordinate. */
struct impact {
    double restitution, duration, overlap, force;
};

static struct impact impact_run(const struct law *law, double mass, double radius, double speed, double dt) {
    struct law_step step = law_step_of(&law->options, dt);
    struct law_contact in = {
        .mass = mass, .radius = radius, .coefficients = law->pair[0][1], .normal = {1.0, 0.0, 0.0}};
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

static const struct law_material glass[2] = {{"glass", 2500.0, 1e9, 0.2}, {"steel", 7200.0, 210e9, 0.2}};

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
                struct law law = law_for(options, glass, pair);
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
        assert_near(law_hooke_damping_ratio(expected[k], LAW_END_FORCE), zeta[k], 1e-5);
    assert_near(law_hooke_damping_ratio(0.729248, LAW_END_OVERLAP), 0.1, 1e-6);
    assert_near(law_hooke_damping_ratio(0.0, LAW_END_OVERLAP), 1.0, 0.0);
    assert_near(law_hertz_alpha(0.0, LAW_END_OVERLAP), sqrt(5.0), 1e-12);
    for (int end = 0; end < 2; end++)
        assert_near(law_hooke_damping_ratio(1.0, end), 0.0, 0.0);
    /* Hertz with the alpha that gives .2 at zero overlap gives .3249 where it ends at zero force */
    assert_near(law_hertz_alpha(0.3249, LAW_END_FORCE), law_hertz_alpha(0.2, LAW_END_OVERLAP), 2e-4);
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
        struct law law = law_for(options, m, (struct law_pair){.restitution = 1.0, .friction = 0.35});
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
                                 .coefficients = law->pair[0][1]};
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
            struct law law = law_for(options, m, (struct law_pair){.restitution = e, .friction = mu});
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

/* Sliding turns into rolling at 5/7 of the speed; before: u = u0 - mu g t, w = 5/2 mu g t / r. */
static void test_sliding_to_rolling(void **state) {
    (void)state;
    struct law law = hooke_law(0.3, 0.0);
    struct ball b = ball_on_plane(&law, 7.0, 0.0, 0.0, 0.4);
    assert_near(b.vx, 7.0 - 0.3 * 10.0 * 0.4, 5e-3);
    assert_near(b.w * b.radius, 2.5 * 0.3 * 10.0 * 0.4, 1e-2);
    b = ball_on_plane(&law, 7.0, 0.0, 0.0, 3.0);
    assert_near(b.vx, 5.0, 5e-3);
    assert_near(b.w * b.radius, 5.0, 5e-3);
}

/* Rolling resistance: a rolling ball loses 5/7 mu_r g; on an incline it gains 5/7 (g_x - mu_r g), and stays
 * where that is negative. */
static void test_rolling_resistance(void **state) {
    (void)state;
    struct law law = hooke_law(0.5, 0.05);
    struct ball b = ball_on_plane(&law, 2.0, 4.0, 0.0, 2.0);
    assert_near(b.vx, 2.0 - 5.0 / 7.0 * 0.05 * 10.0 * 2.0, 5e-3);
    b = ball_on_plane(&law, 0.0, 0.0, 2.0, 1.0);
    assert_near(b.vx, 5.0 / 7.0 * (2.0 - 0.05 * 10.0), 1e-2);
    b = ball_on_plane(&law, 0.0, 0.0, 0.4, 3.0);
    assert_near(b.vx, 0.0, 1e-3);
}

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
    o.normal = k % 3 == 2 ? LAW_HERTZ : LAW_HOOKE;
    o.damping = k % 3 == 0 ? LAW_DAMPING_COEFFICIENT : LAW_DAMPING_RESTITUTION;
    o.end = k / 3 % 2 ? LAW_END_FORCE : LAW_END_OVERLAP;
    o.rolling = k / 6 % 2 ? LAW_ROLLING_SPRING : LAW_ROLLING_NONE;
    o.synchronised = k / 12 % 2;
    o.lammps_hooke = k / 24 % 2 && o.normal == LAW_HOOKE && !o.synchronised;
    return o;
}

enum { OPTIONS = 48 };

static struct law random_law(int k) {
    struct law_pair pair = {.restitution = 0.6,
                            .friction = 0.4,
                            .rolling_friction = 0.2,
                            .k_n = 1e7,
                            .k_t = 3e6,
                            .gamma_n = 500.0,
                            .gamma_t = 200.0};
    return law_for(options_of(k), glass, pair);
}

static void test_mirror(void **state) {
    (void)state;
    struct random_sequence r = random_sequence(1, RANDOM_TEST, 0);
    for (int k = 0; k < OPTIONS; k++) {
        struct law law = random_law(k);
        struct law_case kind = law_case_of(&law.options, true);
        struct law_step step = law_step_of(&law.options, 1e-3);
        for (int trial = 0; trial < 200; trial++) {
            struct law_contact in = random_contact(&r, law.pair[0][1]), back = mirror(in);
            struct law_response a = law_respond(kind, step, &in), b = law_respond(kind, step, &back);
            assert_opposite(a.force, b.force);
            assert_opposite(a.rolling, b.rolling);
            assert_opposite(a.spring, b.spring);
            assert_opposite(a.roll, b.roll);
            assert_opposite(a.moment, law_scale(-1.0, b.moment));
            assert_true(a.normal_energy == b.normal_energy && a.spring_energy == b.spring_energy);
            assert_true(a.dissipated == b.dissipated);
        }
    }
}

/* The tangential force stays in the tangent plane and within the Coulomb limit, the rolling torque within its
 * own; a spring that was cut back gives the limit again; damping takes energy. */
static void test_limits(void **state) {
    (void)state;
    struct random_sequence r = random_sequence(2, RANDOM_TEST, 0);
    int sliding = 0;
    for (int k = 0; k < OPTIONS; k++) {
        struct law law = random_law(k);
        struct law_step step = law_step_of(&law.options, 1e-3);
        for (int trial = 0; trial < 200; trial++) {
            struct law_contact in = random_contact(&r, law.pair[0][1]);
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
            sliding += size > 0.999 * limit;
        }
    }
    assert_true(sliding > 500);
}

/* An empty spring over the limit: no force in LAMMPS's gran/hooke, the limit else. */
static void test_empty_spring(void **state) {
    (void)state;
    struct law law = random_law(0);
    law.options.synchronised = false;
    struct law_contact in = {.overlap = 1e-3,
                             .mass = 1.0,
                             .radius = 1.0,
                             .normal = {0.0, 0.0, 1.0},
                             .half_normal = {0.0, 0.0, 1.0},
                             .velocity = {1e3, 0.0, 0.0},
                             .coefficients = law.pair[0][1]};
    for (int lammps = 0; lammps < 2; lammps++) {
        law.options.lammps_hooke = lammps;
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
        struct law law = random_law(2);
        law.options.synchronised = synchronised;
        law.pair[0][1].c_n = law.pair[0][1].c_t = 0.0;
        law.pair[0][1].friction = 1e9;
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
                                     .coefficients = law.pair[0][1]};
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
        struct law law = random_law(k);
        law.pair[0][1].k_t *= 0.2; /* slides and sticks */
        double dt = 1e-7, mass = 1.0, taken = 0.0, before = 0.5 * (1.0 + 0.09);
        struct law_vector v = {0.3, 0.0, -1.0};
        struct law_contact in = {.mass = mass,
                                 .radius = 1.0,
                                 .normal = {0.0, 0.0, 1.0},
                                 .half_normal = {0.0, 0.0, 1.0},
                                 .coefficients = law.pair[0][1]};
        struct law_response out = {0};
        for (int n = 0; n < 2000 && (n == 0 || in.overlap > 0.0); n++) {
            in.overlap -= v.z * dt;
            in.velocity = v;
            out = law_respond(law_case_of(&law.options, true), law_step_of(&law.options, dt), &in);
            in.spring = out.spring;
            taken += out.dissipated;
            v = law_add(v, dt / mass, out.force);
        }
        double after = 0.5 * law_dot(v, v) + out.normal_energy + out.spring_energy;
        double drift = law.options.normal == LAW_HERTZ ? 2e-2 : 2e-3; /* Mindlin's spring stiffens for free */
        assert_near(after + taken, before, drift * before);
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
    REFUSED("hooke", options.damping = LAW_DAMPING_COEFFICIENT);
    REFUSED("hooke", options.lammps_hooke = true);
    REFUSED("tangential_damping_ratio", options.tangential_damping_ratio = -1.0);
    REFUSED("rolling", options = ((struct law_options){.rolling = LAW_ROLLING_SPRING}));
    REFUSED("velocity_verlet", options = ((struct law_options){.lammps_hooke = true, .synchronised = true}));
    REFUSED("k_n", options = ((struct law_options){.normal = LAW_HOOKE}); row[rows].pair.k_n = 0.0);
    REFUSED("k_t", options.normal = LAW_HOOKE; row[rows].pair.k_t = 0.0);
#undef REFUSED
    for (size_t k = 0; k < rows; k++) {
        struct law law;
        struct error error = {0};
        pairs[0][0] = row[k].pair;
        assert_false(law_prepare(&law, &row[k].options, 1, &row[k].material, pairs, &error));
        assert_int_equal(error.kind, ERROR_USER);
        if (strstr(error.text, row[k].word) == NULL)
            fail_msg("case %zu: \"%s\" does not name %s", k, error.text, row[k].word);
    }
}

/* What a scene needs follows from the options. */
static void test_needs(void **state) {
    (void)state;
    struct law_options options = law_options_default();
    const struct law_pair pair = {.restitution = 0.5, .friction = 0.3, .rolling_friction = 0.1};
    struct law law = law_for(options, glass, pair);
    assert_true(law.spin && law.history_components == 3 && law.range == 0.0);
    /* unlike materials: 1/E* and 1/G* add up, the same from both sides */
    double e = 1.0 / (0.96 / 1e9 + 0.96 / 210e9);
    assert_near(law.young_effective[0][1] / e, 1.0, 1e-14);
    assert_near(law.pair[0][1].k_n / (4.0 / 3.0 * e), 1.0, 1e-14);
    assert_near(law.pair[1][0].k_t / (8.0 / (1.8 * 2.4 / 1e9 + 1.8 * 2.4 / 210e9)), 1.0, 1e-14);
    options.rolling = LAW_ROLLING_SPRING;
    law = law_for(options, glass, pair);
    assert_int_equal(law.history_components, 6);
    options = law_options_default();
    options.tangential = LAW_FRICTIONLESS;
    law = law_for(options, glass, pair);
    assert_true(!law.spin && law.history_components == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_restitution),
                                       cmocka_unit_test(test_restitution_ends),
                                       cmocka_unit_test(test_chung_ooi),
                                       cmocka_unit_test(test_gross_sliding),
                                       cmocka_unit_test(test_sliding_to_rolling),
                                       cmocka_unit_test(test_rolling_resistance),
                                       cmocka_unit_test(test_mirror),
                                       cmocka_unit_test(test_limits),
                                       cmocka_unit_test(test_empty_spring),
                                       cmocka_unit_test(test_rigid_rotation),
                                       cmocka_unit_test(test_energy_balance),
                                       cmocka_unit_test(test_refused),
                                       cmocka_unit_test(test_needs)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
