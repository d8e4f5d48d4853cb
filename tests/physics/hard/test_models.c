/* SPDX-License-Identifier: BSD-3-Clause */
/* Models of single contacts (src/physics/hard/models.h), contacts of bodies that are no spheres (general.c), and the choice of points
 * (thin.h). */
#include "tests/test.h"

#include "base/random.h"
#include "physics/hard/models.h"
#include "physics/hard/problem.h"
#include "physics/hard/row.h"
#include "physics/hard/thin.h"
#include <string.h>
/* after setjmp.h and stdarg.h */

enum { CASES = 300 };

static double between(struct random_sequence *random, double low, double high) {
    return low + (high - low) * random_uniform(random);
}

/* A contact of spheres, or one whose normal and tangents are coupled, that closes. */
static struct hard_local local_make(uint64_t number, bool coupled) {
    struct random_sequence random = random_sequence(23, RANDOM_TEST, number);
    struct hard_local local = {.friction = between(&random, 0.05, 0.5)};
    double j[9];
    for (int k = 0; k < 9; k++)
        j[k] = coupled ? between(&random, -0.6, 0.6) : 0.0;
    double n = between(&random, 0.5, 2.0), t = 3.5 * n;
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            local.a[3 * a + b] = a != b ? 0.0 : a == 0 || coupled ? n : t;
            for (int k = 0; k < 3; k++)
                local.a[3 * a + b] += j[3 * k + a] * j[3 * k + b];
        }
    local.c[0] = between(&random, -2.0, -0.2);
    local.c[1] = between(&random, -2.0, 2.0);
    local.c[2] = between(&random, -2.0, 2.0);
    return local;
}

static void velocity(const struct hard_local *l, const double p[3], double w[3]) {
    for (int d = 0; d < 3; d++)
        w[d] = l->c[d] + l->a[3 * d] * p[0] + l->a[3 * d + 1] * p[1] + l->a[3 * d + 2] * p[2];
}

static void solve(enum hard_model_number model, const struct hard_local *l, double p[3]) {
    p[0] = p[1] = p[2] = 0.0;
    hard_relax_model(model)->relax(l, p);
}

static double left(const struct hard_local *l, const double p[3]) {
    double w[3], sum = 0.0;
    velocity(l, p, w);
    for (int d = 0; d < 3; d++)
        sum += 0.5 * p[d] * (l->c[d] + w[d]);
    return sum;
}

/* Closed, in the cone, and sticking or sliding against the slip. */
static bool is_coulomb(const struct hard_local *l, const double p[3], double tolerance) {
    double w[3], slip, rub = hypot(p[1], p[2]), most = l->friction * p[0];
    velocity(l, p, w);
    slip = hypot(w[1], w[2]);
    bool slides = fabs(rub - most) <= tolerance &&
                  fabs(p[1] * w[1] + p[2] * w[2] + rub * slip) <= tolerance * fmax(1.0, slip);
    return p[0] > 0.0 && fabs(w[0]) <= tolerance && rub <= most + tolerance && (slip <= tolerance || slides);
}

/* All models of Coulomb's law have the closed form of spheres. */
static void test_spheres(void **state) {
    (void)state;
    const enum hard_model_number models[] = {HARD_MODEL_COULOMB, HARD_MODEL_DECOUPLED, HARD_MODEL_DE_SAXCE,
                                             HARD_MODEL_DISSIPATION};
    for (uint64_t k = 0; k < CASES; k++) {
        const struct hard_local l = local_make(k, false);
        double n = -l.c[0] / l.a[0], t[2] = {-l.c[1] / l.a[4], -l.c[2] / l.a[8]}, p[3], w[3];
        double keep = fmin(1.0, l.friction * n / hypot(t[0], t[1]));
        for (int m = 0; m < 4; m++) {
            solve(models[m], &l, p);
            double tolerance =
                models[m] == HARD_MODEL_DISSIPATION ? 1e-6 : 1e-10; /* of a search for a least value */
            assert_true(fabs(p[0] - n) < tolerance);
            assert_true(fabs(p[1] - keep * t[0]) < tolerance && fabs(p[2] - keep * t[1]) < tolerance);
            assert_true(hard_relax_model(models[m])->closed);
        }
        solve(HARD_MODEL_FRICTIONLESS, &l, p);
        assert_true(fabs(p[0] - n) < 1e-14 && p[1] == 0.0 && p[2] == 0.0);
        solve(HARD_MODEL_PROJECTION, &l, p); /* opens by friction x slip */
        velocity(&l, p, w);
        assert_true(fabs(w[0] - l.friction * hypot(w[1], w[2])) < 1e-9);
    }
}

/* Of coupled contacts Coulomb's law and De Saxce's projection are one, maximum dissipation leaves no more energy, and the
 * decoupled model is another. */
static void test_coupled(void **state) {
    (void)state;
    int others = 0;
    for (uint64_t k = 0; k < CASES; k++) {
        const struct hard_local l = local_make(k, true);
        double exact[3], p[3], w[3];
        solve(HARD_MODEL_COULOMB, &l, exact);
        assert_true(is_coulomb(&l, exact, 1e-10));
        solve(HARD_MODEL_DE_SAXCE, &l, p);
        for (int d = 0; d < 3; d++)
            assert_true(fabs(p[d] - exact[d]) < 1e-8);
        solve(HARD_MODEL_DISSIPATION, &l, p);
        velocity(&l, p, w);
        assert_true(fabs(w[0]) < 1e-9);
        assert_true(left(&l, p) <= left(&l, exact) + 1e-9);
        solve(HARD_MODEL_DECOUPLED, &l, p);
        assert_true(hypot(p[1], p[2]) <= l.friction * p[0] * (1.0 + 1e-12));
        others += !is_coulomb(&l, p, 1e-6);
    }
    assert_true(others > CASES / 2);
}

/* A thin rod, which leans by an angle, comes down on a floor with its lower end. */
struct rod {
    struct hard_body body[2];
    double turn[HARD_TENSOR];
    struct hard_arm arm;
    struct hard_row row;
};

static void rod_make(struct rod *rod, double angle, double friction) {
    const double mass = 2.0, inertia = mass / 3.0; /* half length 1 */
    *rod = (struct rod){.turn = {1.0 / inertia, 1.0 / inertia, 1.0 / inertia}};
    rod->body[1] = (struct hard_body){.v = {0, 0, -1}, .lightness = 1.0 / mass, .swing = 1.0};
    rod->arm = (struct hard_arm){.lever = {{0}, {cos(angle), 0, -sin(angle)}},
                                 .turn = {NULL, rod->turn},
                                 .start = {0, 0, -1},
                                 .relax = hard_relax_model(HARD_MODEL_COULOMB)->relax};
    rod->row = (struct hard_row){.body = {0, 1},
                                 .normal = {0, 0, 1},
                                 .release = INFINITY,
                                 .friction = friction,
                                 .restitution = 0.5,
                                 .approach = 1.0,
                                 .impact = true,
                                 .arm = &rod->arm};
}

static double energy(const struct rod *rod) {
    const struct hard_body *b = &rod->body[1];
    return 0.5 * vector_dot(b->v, b->v) / b->lightness + 0.5 * vector_dot(b->w, b->w) / rod->turn[0];
}

/* Without friction the impulse is u / (1/m + x^2/I), with enough of it the end comes to rest; impacts with any friction take energy. */
static void test_rod(void **state) {
    (void)state;
    for (double angle = 0.1; angle < 1.5; angle += 0.1)
        for (double friction = 0.0; friction < 3.0; friction += 0.25) {
            struct rod rod;
            double u[3], whole;
            rod_make(&rod, angle, friction);
            hard_visit(&rod.row, 1e-3, &rod.body[0], &rod.body[1]);
            hard_velocity(&rod.row, &rod.body[0], &rod.body[1], u);
            assert_true(fabs(u[2]) < 1e-12);
            if (friction <= 0.0)
                assert_true(fabs(rod.row.p - 2.0 / (1.0 + 3.0 * cos(angle) * cos(angle))) < 1e-14);
            /* both at once: tangential impulse over normal one that sticks */
            double along = 1.0 + 3.0 * sin(angle) * sin(angle), both = 3.0 * sin(angle) * cos(angle);
            if (friction > both / along + 1e-9)
                assert_true(fabs(u[0]) < 1e-12);
            whole = energy(&rod);
            assert_true(whole <= 1.0 + 1e-12);
            rod_make(&rod, angle, friction);
            hard_visit(&rod.row, 1e-3, &rod.body[0], &rod.body[1]);
            hard_rebound(&rod.row, &rod.body[0], &rod.body[1]);
            hard_velocity(&rod.row, &rod.body[0], &rod.body[1], u);
            assert_true(u[2] > -1e-12 && u[2] <= 0.5 + 1e-12);
            assert_true(energy(&rod) <= 1.0 + 1e-12);
            if (friction <= 0.0)
                assert_true(fabs(u[2] - 0.5) < 1e-12);
        }
}

/* A rod that falls flat on both of its ends, with friction or without, leaves with both. */
static void test_flat(void **state) {
    (void)state;
    for (int rough = 0; rough < 2; rough++) {
        struct rod rod, other;
        double u[3];
        rod_make(&rod, 0.0, rough ? 0.5 : 0.0);
        rod_make(&other, 0.0, rough ? 0.5 : 0.0);
        other.row.arm = &other.arm;
        other.arm.lever[1][0] = -1.0;
        for (int k = 0; k < 40; k++) {
            hard_visit(&rod.row, 1e-3, &rod.body[0], &rod.body[1]);
            hard_visit(&other.row, 1e-3, &rod.body[0], &rod.body[1]);
        }
        for (int k = 0; k < 40; k++) {
            hard_rebound(&rod.row, &rod.body[0], &rod.body[1]);
            hard_rebound(&other.row, &rod.body[0], &rod.body[1]);
        }
        hard_velocity(&rod.row, &rod.body[0], &rod.body[1], u);
        assert_true(fabs(u[2] - 0.5) < 1e-9);
        hard_velocity(&other.row, &rod.body[0], &rod.body[1], u);
        assert_true(fabs(u[2] - 0.5) < 1e-9);
        assert_true(fabs(rod.row.p - 1.5) < 1e-9 && fabs(other.row.p - 1.5) < 1e-9);
    }
}

/* A row of spheres with an arm is the row without. */
static void test_arm(void **state) {
    (void)state;
    for (uint64_t k = 0; k < CASES; k++) {
        struct random_sequence random = random_sequence(29, RANDOM_TEST, k);
        struct hard_body body[2];
        struct hard_row row = {
            .body = {0, 1}, .normal = {0, 0.6, 0.8}, .lever = {0.5, 0.7}, .release = INFINITY};
        struct hard_arm arm = {.relax = hard_relax_model(HARD_MODEL_COULOMB)->relax};
        struct hard_resist resist = {.radius = 0.7, .roll_soft = k % 4 ? 0.1 : -1.0, .twist_soft = 0.3};
        struct hard_answer answer[2] = {0};
        for (int e = 0; e < 2; e++) {
            body[e].lightness = between(&random, 0.5, 2.0);
            body[e].swing = 2.5 * body[e].lightness / (row.lever[e] * row.lever[e]);
            for (int d = 0; d < 3; d++) {
                body[e].v[d] = between(&random, -1.0, 1.0) - (e ? row.normal[d] : -row.normal[d]);
                body[e].w[d] = between(&random, -3.0, 3.0);
                arm.lever[e][d] = (e ? -row.lever[1] : row.lever[0]) * row.normal[d];
            }
        }
        row.friction = between(&random, 0.0, 1.0);
        row.bias = between(&random, -1.0, 0.5);
        row.soft_n = 0.1;
        row.soft_t = 0.2;
        if (k % 3 == 0)
            row.release = 0.05;
        if (k % 3 == 1) {
            row.hertz = 10.0;
            row.shear = 1.0;
            row.gap = -0.01;
        }
        resist.roll_friction = between(&random, 0.0, 0.5);
        resist.twist_friction = between(&random, 0.0, 0.5);
        for (int d = 0; d < 3; d++)
            resist.hold.roll[d] = between(&random, -0.1, 0.1) * (row.normal[d] == 0.0);
        if (k % 2)
            row.resist = &resist;
        if (k % 5 == 0)
            row.press = 0.2; /* of a cohesion */
        struct hard_row other = row;
        other.arm = &arm;
        hard_wish(&row, 0.1, &body[0], &body[1], &answer[0]);
        hard_wish(&other, 0.1, &body[0], &body[1], &answer[1]);
        assert_true(fabs(answer[1].p - answer[0].p) < 1e-12);
        assert_true(fabs(answer[1].couple.twist - answer[0].couple.twist) < 1e-12);
        for (int d = 0; d < 3; d++) {
            assert_true(fabs(answer[1].q[d] - answer[0].q[d]) <
                        (k % 2 ? 1e-7 : 1e-12)); /* force and couple in turns */
            assert_true(fabs(answer[1].couple.roll[d] - answer[0].couple.roll[d]) < (k % 2 ? 1e-7 : 1e-12));
        }
        assert_true(fabs(hard_push(&row, &body[0], &body[1]) - hard_push(&other, &body[0], &body[1])) <
                    1e-13);
        assert_true(fabs(hard_slide(&row, &body[0], &body[1]) - hard_slide(&other, &body[0], &body[1])) <
                    1e-12);
    }
}

/* Of a face of points its corners are kept, and points of another direction are a face of their own. */
static void test_thin(void **state) {
    (void)state;
    enum { SIDE = 5, FACE = SIDE * SIDE };
    struct hard_point point[FACE + 2];
    memset(point, 0, sizeof point);
    for (int k = 0; k < FACE; k++) {
        point[k].number = point[k].order = (uint64_t)k;
        point[k].place[0] = k % SIDE;
        point[k].place[1] = k / SIDE;
        point[k].normal[2] = 1.0;
        point[k].gap = k ? -1e-3 : -2e-3;
    }
    for (int k = FACE; k < FACE + 2; k++) {
        point[k].number = point[k].order = (uint64_t)k;
        point[k].normal[0] = 1.0;
        point[k].place[2] = k;
    }
    hard_thin(point, FACE + 2);
    int kept = 0;
    for (int k = 0; k < FACE; k++) {
        bool corner = (k % SIDE == 0 || k % SIDE == SIDE - 1) && (k / SIDE == 0 || k / SIDE == SIDE - 1);
        assert_true(point[k].keep == corner);
        kept += point[k].keep;
    }
    assert_int_equal(kept, HARD_POINTS);
    assert_true(point[FACE].keep && point[FACE + 1].keep);
}

/* Spheres of a ring that all touch their neighbours fly inwards with e = 1: Poisson's restitution never adds energy. */
static void test_poisson(void **state) {
    (void)state;
    enum { RING = 6, SWEEPS = 400 };
    for (uint64_t k = 0; k < CASES; k++) {
        struct random_sequence random = random_sequence(31, RANDOM_TEST, k);
        struct hard_problem problem = {0};
        double before = 0.0, after = 0.0, momentum[2] = {0.0, 0.0};
        hard_problem_reserve(&problem, RING, RING, 1);
        hard_problem_begin(&problem, 1e-3);
        problem.bodies = problem.rows = RING;
        problem.cut[++problem.cuts] = RING;
        hard_problem_end_colour(&problem);
        for (int b = 0; b < RING; b++) {
            double angle = 2.0 * M_PI * b / RING, mass = between(&random, 0.5, 2.0);
            problem.body[b] = (struct hard_body){.v = {-cos(angle) + between(&random, -0.5, 0.5),
                                                       -sin(angle) + between(&random, -0.5, 0.5), 0.0},
                                                 .lightness = 1.0 / mass,
                                                 .swing = 2.5 / mass};
            before += 0.5 * mass * vector_dot(problem.body[b].v, problem.body[b].v);
            momentum[0] += mass * problem.body[b].v[0];
        }
        for (uint32_t b = 0; b < RING; b++) {
            double angle = 2.0 * M_PI * (b + 0.5) / RING;
            problem.row[b] = (struct hard_row){.body = {b, (b + 1) % RING},
                                               .normal = {-sin(angle), cos(angle), 0.0},
                                               .lever = {1.0, 1.0},
                                               .release = INFINITY,
                                               .friction = k % 2 ? 0.5 : 0.0,
                                               .restitution = 1.0,
                                               .impact = true};
        }
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            hard_problem_sweep(&problem, HARD_TURN_ALL);
        assert_true(hard_problem_expand(&problem));
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            hard_problem_sweep(&problem, HARD_TURN_ALL);
        for (int b = 0; b < RING; b++) {
            const struct hard_body *body = &problem.body[b];
            after += 0.5 * vector_dot(body->v, body->v) / body->lightness +
                     0.5 * vector_dot(body->w, body->w) / body->swing;
            momentum[1] += body->v[0] / body->lightness;
        }
        assert_true(after <= before * (1.0 + 1e-9));
        assert_true(fabs(momentum[1] - momentum[0]) < 1e-12);
        hard_problem_free(&problem);
    }
}

TEST_MAIN(models, cmocka_unit_test(test_spheres), cmocka_unit_test(test_coupled), cmocka_unit_test(test_rod),
          cmocka_unit_test(test_flat), cmocka_unit_test(test_arm), cmocka_unit_test(test_thin),
          cmocka_unit_test(test_poisson))
