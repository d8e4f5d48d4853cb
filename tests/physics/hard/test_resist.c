/* SPDX-License-Identifier: BSD-3-Clause */
/* Rolling and twisting of hard contacts against closed forms (src/physics/hard/resist.h). */
#include "tests/test.h"

#include "base/random.h"
#include "physics/hard/problem.h"
#include <string.h>
/* after setjmp.h and stdarg.h */
#include "tests/near.h"

enum { CASES = 400 };
static const double dt = 1e-3;

static double between(struct random_sequence *random, double low, double high) {
    return low + (high - low) * random_uniform(random);
}

static void tangent_draw(struct random_sequence *random, const double normal[3], double size, double out[3]) {
    double any[3];
    for (int d = 0; d < 3; d++)
        any[d] = between(random, -size, size);
    vector_cross(normal, any, out);
}

/* Two spheres that meet in some way, or one at a wall. */
static void case_make(struct random_sequence *random, bool wall, struct hard_row *row,
                      struct hard_resist *resist, struct hard_body body[2]) {
    *row = (struct hard_row){.body = {0, 1},
                             .normal = {0.48, 0.64, -0.6},
                             .lever = {between(random, 0.5, 2.0), between(random, 0.5, 2.0)},
                             .release = INFINITY,
                             .friction = between(random, 0.0, 1.0),
                             .soft_n = 0.1,
                             .soft_t = 0.2,
                             .bias = -0.2,
                             .resist = resist};
    *resist = (struct hard_resist){.radius = between(random, 0.3, 1.0),
                                   .roll_friction = between(random, 0.0, 0.5),
                                   .twist_friction = between(random, 0.0, 0.5),
                                   .roll_soft = between(random, -0.1, 0.3),
                                   .twist_soft = 0.3,
                                   .hold.twist = between(random, -0.1, 0.1)};
    tangent_draw(random, row->normal, 0.1, resist->hold.roll);
    tangent_draw(random, row->normal, 0.1, row->hold);
    for (int e = 0; e < 2; e++) {
        body[e] = (struct hard_body){.lightness = wall && e ? 0.0 : between(random, 0.5, 2.0)};
        body[e].swing = 2.5 * body[e].lightness / (row->lever[e] * row->lever[e]);
        for (int d = 0; d < 3; d++) {
            body[e].v[d] = between(random, -1.0, 1.0) - (e ? row->normal[d] : -row->normal[d]);
            body[e].w[d] = between(random, -3.0, 3.0);
        }
    }
}

/* A part of the contact: held with a rate of 0, or at its limit with the rate against it. */
static void part_holds(const double x[3], const double hold[3], const double rate[3], double soft,
                       double most) {
    double left[3], size = sqrt(vector_dot(x, x)), along;
    for (int d = 0; d < 3; d++)
        left[d] = rate[d] + soft * (x[d] - hold[d]);
    assert_true(size <= most * (1.0 + 1e-12));
    double rest = sqrt(vector_dot(left, left));
    if (size < most * (1.0 - 1e-9)) {
        assert_true(rest < 1e-9);
        return;
    }
    along = vector_dot(left, x);
    assert_near(along, -rest * size, 1e-9);
}

/* A single visit ends with the law of each part, whatever holds and whatever slips. */
static void test_visit(void **state) {
    (void)state;
    int seen[2][2] = {{0}};
    for (uint64_t k = 0; k < CASES; k++) {
        struct random_sequence random = random_sequence(37, RANDOM_TEST, k);
        struct hard_row row;
        struct hard_resist resist;
        struct hard_body body[2];
        double u[3], w[3], slip[3], roll[3];
        case_make(&random, k % 3 == 0, &row, &resist, body);
        hard_visit(&row, dt, &body[0], &body[1]);
        if (!(row.p > 0.0))
            continue;
        hard_velocity(&row, &body[0], &body[1], u);
        vector_minus(body[1].w, body[0].w, w);
        double u_n = vector_dot(u, row.normal), w_n = vector_dot(w, row.normal);
        for (int d = 0; d < 3; d++) {
            slip[d] = u[d] - u_n * row.normal[d];
            roll[d] = resist.radius * (w[d] - w_n * row.normal[d]);
        }
        const double soft = resist.roll_soft < 0.0 ? row.soft_t : resist.roll_soft,
                     most = resist.roll_friction * row.p;
        part_holds(row.q, row.hold, slip, row.soft_t, row.friction * row.p);
        part_holds(resist.now.roll, resist.hold.roll, roll, soft, most);
        const double twist[3] = {resist.now.twist}, rest[3] = {resist.hold.twist},
                     rate[3] = {resist.radius * w_n};
        part_holds(twist, rest, rate, resist.twist_soft, resist.twist_friction * row.p);
        seen[vector_dot(row.q, row.q) < 0.999 * row.friction * row.friction * row.p * row.p]
            [vector_dot(resist.now.roll, resist.now.roll) < 0.999 * most * most]++;
    }
    for (int k = 0; k < 4; k++)
        assert_true(seen[k / 2][k % 2] > 5);
}

/* With the bodies exchanged and the normal turned round all is the same to the last bit. */
static void test_exchange(void **state) {
    (void)state;
    for (uint64_t k = 0; k < CASES; k++) {
        struct random_sequence random = random_sequence(41, RANDOM_TEST, k);
        struct hard_row row, other;
        struct hard_resist resist, turned;
        struct hard_body body[2], end[2];
        case_make(&random, false, &row, &resist, body);
        other = row;
        turned = resist;
        other.resist = &turned;
        for (int e = 0; e < 2; e++) {
            end[e] = body[1 - e];
            other.lever[e] = row.lever[1 - e];
        }
        for (int d = 0; d < 3; d++) {
            other.normal[d] = -row.normal[d];
            other.hold[d] = -row.hold[d];
            turned.hold.roll[d] = -resist.hold.roll[d];
        }
        for (int visit = 0; visit < 2; visit++) {
            hard_visit(&row, dt, &body[0], &body[1]);
            hard_visit(&other, dt, &end[0], &end[1]);
        }
        assert_true(turned.now.twist == resist.now.twist);
        for (int d = 0; d < 3; d++) {
            assert_true(turned.now.roll[d] == -resist.now.roll[d]);
            assert_true(end[0].w[d] == body[1].w[d] && end[1].v[d] == body[0].v[d]);
        }
    }
}

/* A sphere of mass 2 and radius 1 on a floor, with rigid rows, on which gravity has acted for dt. */
static void floor_make(struct hard_row *row, struct hard_resist *resist, struct hard_body body[2]) {
    *resist = (struct hard_resist){.radius = 1.0, .roll_friction = 0.1, .twist_friction = 0.05};
    *row = (struct hard_row){.body = {0, 1},
                             .normal = {0, 0, 1},
                             .lever = {0, 1},
                             .release = INFINITY,
                             .friction = 0.5,
                             .resist = resist};
    body[0] = (struct hard_body){.lightness = 0.0};
    body[1] = (struct hard_body){.v = {0, 0, -10.0 * dt}, .lightness = 0.5, .swing = 2.5 * 0.5};
}

/* A rolling sphere is slowed down by 5/7 mu_r g, a spinning one by 5/2 mu_t g / r: (7/5) m r^2 and (2/5) m r^2 turn. */
static void test_slows(void **state) {
    (void)state;
    struct hard_row row;
    struct hard_resist resist;
    struct hard_body body[2];
    floor_make(&row, &resist, body);
    body[1].v[0] = body[1].w[1] = 1.0;
    body[1].w[2] = 3.0;
    hard_visit(&row, dt, &body[0], &body[1]);
    assert_near(body[1].v[0], 1.0 - 5.0 / 7.0 * 0.1 * 10.0 * dt, 1e-15);
    assert_near(body[1].w[1], body[1].v[0], 1e-15);
    assert_near(body[1].w[2], 3.0 - 2.5 * 0.05 * 10.0 * dt, 1e-15);
    floor_make(&row, &resist, body); /* slower than that: it stops, and stays */
    body[1].v[0] = body[1].w[1] = 0.5 * 5.0 / 7.0 * 0.1 * 10.0 * dt;
    hard_visit(&row, dt, &body[0], &body[1]);
    assert_near(body[1].v[0], 0.0, 1e-17);
    assert_near(sqrt(vector_dot(resist.now.roll, resist.now.roll)), 0.5 * 0.1 * row.p, 1e-16);
}

/* On a slope it stays if tan <= mu_r, and friction holds; else rolls with 5/7 g (sin - mu_r cos). */
static void test_slope(void **state) {
    (void)state;
    for (int steep = 0; steep < 2; steep++) {
        struct hard_row row;
        struct hard_resist resist;
        struct hard_body body[2];
        floor_make(&row, &resist, body);
        double tangent = steep ? 0.12 : 0.0999;
        body[1].v[0] = tangent * 10.0 * dt; /* gravity across, 10 of it down */
        hard_visit(&row, dt, &body[0], &body[1]);
        assert_near(body[1].v[0], steep ? 5.0 / 7.0 * (0.12 - 0.1) * 10.0 * dt : 0.0, 1e-16);
    }
}

/* The residual sees a couple that is missing, and an impact with resistances takes energy. */
static void test_residual(void **state) {
    (void)state;
    struct hard_problem problem = {0};
    struct hard_resist resist;
    double sum[3], before, after;
    hard_problem_reserve(&problem, 2, 1, 1);
    hard_problem_begin(&problem, dt);
    problem.bodies = 2;
    problem.rows = 1;
    problem.cut[++problem.cuts] = 1;
    hard_problem_end_colour(&problem);
    floor_make(&problem.row[0], &resist, problem.body);
    struct hard_row *row = &problem.row[0];
    struct hard_body *body = &problem.body[1];
    body->v[0] = body->w[1] = 1.0;
    hard_problem_sweep(&problem, HARD_TURN_ALL);
    hard_problem_residual(&problem, sum);
    assert_true(sum[0] < 1e-24 * sum[1]);
    hard_couple_change(row, &problem.body[0], body, &(struct hard_couple){{0}, 0.0});
    hard_problem_residual(&problem, sum);
    assert_true(sqrt(sum[0] / sum[2]) > 0.05);
    floor_make(row, &resist, problem.body);
    body->v[2] = -2.0;
    body->v[0] = 1.0;
    body->w[2] = 2.0;
    row->impact = true;
    row->approach = 2.0;
    row->restitution = 0.5;
    before = 2.0 * 0.5 * vector_dot(body->v, body->v) + 0.5 * vector_dot(body->w, body->w) / body->swing;
    hard_problem_sweep(&problem, HARD_TURN_ALL);
    for (int k = 0; k < 8; k++)
        hard_problem_rebound(&problem, HARD_TURN_ALL);
    after = 2.0 * 0.5 * vector_dot(body->v, body->v) + 0.5 * vector_dot(body->w, body->w) / body->swing;
    assert_near(body->v[2], 1.0, 1e-15);
    assert_near(row->p, 6.0, 1e-14);
    assert_near(fabs(resist.now.twist), 0.05 * row->p, 1e-12); /* of the whole impulse */
    assert_true(after < before);
    hard_problem_free(&problem);
}

TEST_MAIN(resist, cmocka_unit_test(test_visit), cmocka_unit_test(test_exchange), cmocka_unit_test(test_slows),
          cmocka_unit_test(test_slope), cmocka_unit_test(test_residual))
