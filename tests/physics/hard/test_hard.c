/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows, sweeps and colours of hard contacts against closed forms (src/physics/hard/row.h, problem.h, colour.h). */
#include "tests/test.h"

#include "base/random.h"
#include "physics/hard/colour.h"
#include "physics/hard/hard.h"
#include "physics/hard/problem.h"
#include <stdlib.h>
#include <string.h>
/* after setjmp.h and stdarg.h */
#include "tests/near.h"

enum { CHAIN_MOST = 60 };
static const double gravity = 10.0, step = 1e-3;

/* A solid sphere. */
static struct hard_body sphere(double mass, double radius, const double v[3]) {
    return (struct hard_body){
        .v = {v[0], v[1], v[2]}, .lightness = 1.0 / mass, .swing = 2.5 / (mass * radius * radius)};
}

/* A contact of two bodies along z; kappa INFINITY: rigid. */
static struct hard_row contact(const struct hard_body *body, uint32_t a, uint32_t b, double kappa) {
    struct hard_row row = {
        .body = {a, b}, .normal = {0, 0, 1}, .lever = {1, 1}, .release = INFINITY, .friction = 0.0};
    row.soft_n = hard_push(&row, &body[a], &body[b]) / kappa;
    row.soft_t = hard_slide(&row, &body[a], &body[b]) / kappa;
    return row;
}

/* A problem of one cut: its rows, which are still to be set, are visited in order. */
static void problem_begin(struct hard_problem *problem, size_t bodies, size_t rows) {
    *problem = (struct hard_problem){0};
    hard_problem_reserve(problem, bodies, rows, rows);
    hard_problem_begin(problem, step);
    problem->bodies = bodies;
    problem->rows = rows;
    problem->cut[++problem->cuts] = rows;
    hard_problem_end_colour(problem);
}

/* A floor (body 0) and n spheres upon one another, the top contact first; the top sphere has mass `top`. */
static void chain_make(struct hard_problem *problem, uint32_t n, double kappa, double top) {
    const double v[3] = {0, 0, -gravity * step};
    problem_begin(problem, n + 1, n);
    problem->body[0] = (struct hard_body){0};
    for (uint32_t k = 1; k <= n; k++)
        problem->body[k] = sphere(k == n ? top : 1.0, 1.0, v);
    for (uint32_t k = 0; k < n; k++)
        problem->row[k] = contact(problem->body, n - 1 - k, n - k, kappa);
}

/* A floor (body 0), and a sphere of radius 1 on it (body 1); their contact is rigid and without friction. */
static void single_make(struct hard_problem *problem, double mass, const double v[3]) {
    problem_begin(problem, 2, 1);
    problem->body[0] = (struct hard_body){0};
    problem->body[1] = sphere(mass, 1.0, v);
    problem->row[0] = contact(problem->body, 0, 1, INFINITY);
}

static double residual(const struct hard_problem *problem) {
    double sum[3];
    hard_problem_residual(problem, sum);
    return sqrt(sum[0] / fmax(sum[1], sum[2]));
}

/* Sweeps until each force of a rigid chain is within `part` of its weight. */
static int chain_sweeps(uint32_t n, double part) {
    struct hard_problem problem;
    int sweeps = 0;
    double worst = 1.0;
    chain_make(&problem, n, INFINITY, 1.0);
    for (; worst > part; sweeps++) {
        hard_problem_sweep(&problem, HARD_TURN_ALL);
        worst = 0.0;
        for (uint32_t k = 0; k < n; k++) {
            double weight = (k + 1) * gravity * step;
            worst = fmax(worst, fabs(problem.row[k].p - weight) / weight);
        }
    }
    hard_problem_free(&problem);
    return sweeps;
}

static int sweeps_until(struct hard_problem *problem, double tolerance) {
    int sweeps = 0;
    do {
        hard_problem_sweep(problem, HARD_TURN_ALL);
        sweeps++;
    } while (residual(problem) > tolerance && sweeps < 100000);
    return sweeps;
}

/* 1.95 N^2 cold sweeps of rigid rows to 1 % of the forces, which are N - i weights. */
static void test_chain_rigid(void **state) {
    (void)state;
    const uint32_t n[] = {5, 10, 20, 40};
    for (int k = 0; k < 4; k++) {
        double law = 1.95 * n[k] * n[k], sweeps = chain_sweeps(n[k], 0.01);
        assert_true(fabs(sweeps - law) < 0.15 * law);
    }
}

/* With kappa = 4 pi^2 the count does not grow with the depth. */
static void test_chain_soft(void **state) {
    (void)state;
    int sweeps[2];
    for (int k = 0; k < 2; k++) {
        struct hard_problem problem;
        chain_make(&problem, k ? CHAIN_MOST : 20, HARD_KAPPA, 1.0);
        sweeps[k] = sweeps_until(&problem, 1e-4);
        hard_problem_free(&problem);
    }
    assert_true(abs(sweeps[1] - sweeps[0]) <= 0.1 * sweeps[0]);
    assert_true(sweeps[1] < 3 * HARD_KAPPA);
}

/* The solved forces are the solution: begun from them, nothing changes. */
static void test_chain_warm(void **state) {
    (void)state;
    struct hard_problem again;
    chain_make(&again, CHAIN_MOST, INFINITY, 1.0);
    for (uint32_t k = 0; k < CHAIN_MOST; k++)
        again.row[k].p = (k + 1) * gravity * step;
    hard_problem_warm(&again);
    assert_true(residual(&again) < 1e-13);
    for (uint32_t k = 1; k <= CHAIN_MOST; k++)
        assert_true(fabs(again.body[k].v[2]) < 1e-14);
    hard_problem_free(&again);
}

/* A heavy sphere on a light one: 4.6 M/m sweeps of rigid rows to 1 %, and a bounded number of soft ones. */
static void test_heavy(void **state) {
    (void)state;
    for (double top = 10.0; top <= 1000.0; top *= 10.0) {
        struct hard_problem problem;
        int sweeps = 0;
        chain_make(&problem, 2, INFINITY, top);
        while (fabs(problem.row[0].p / (top * gravity * step) - 1.0) > 0.01) {
            hard_problem_sweep(&problem, HARD_TURN_ALL);
            sweeps++;
        }
        assert_true(fabs(sweeps - 4.6 * top) < 0.15 * 4.6 * top + 3);
        hard_problem_free(&problem);
        chain_make(&problem, 2, HARD_KAPPA, 1000.0 * top);
        assert_true(sweeps_until(&problem, 1e-4) < 3 * HARD_KAPPA);
        hard_problem_free(&problem);
    }
}

/* A single contact has a closed form, which one visit finds: it sticks or slides. */
static void test_single(void **state) {
    (void)state;
    for (int slides = 0; slides < 2; slides++) {
        struct hard_problem problem;
        single_make(&problem, 2.0, (double[3]){0.7, 0, -0.5});
        problem.row[0].friction = slides ? 0.1 : 10.0;
        hard_problem_sweep(&problem, HARD_TURN_ALL);
        const struct hard_body *b = &problem.body[1];
        assert_true(fabs(problem.row[0].p - 2.0 * 0.5) < 1e-15);
        assert_true(fabs(b->v[2]) < 1e-16);
        double v = slides ? 0.7 - 0.1 * 0.5 : 0.7 * 5.0 / 7.0; /* 2/7 of the slip goes into the velocity */
        assert_true(fabs(b->v[0] - v) < 1e-15);
        assert_true(fabs(b->w[1] - 2.5 * (0.7 - v)) < 1e-14);
        assert_true(residual(&problem) < 1e-14);
        hard_problem_free(&problem);
    }
}

/* A row whose gap is open does not push before it closes, and an overlap is released no faster than asked. */
static void test_gap(void **state) {
    (void)state;
    struct hard_problem problem;
    single_make(&problem, 1.0, (double[3]){0, 0, -0.5});
    problem.row[0].gap = 0.3 * step;
    problem.row[0].bias = 0.3;
    hard_problem_sweep(&problem, HARD_TURN_ALL);
    assert_true(fabs(problem.body[1].v[2] + 0.3) < 1e-15);
    problem.row[0].bias = -5.0;
    problem.row[0].release = 0.01;
    hard_problem_sweep(&problem, HARD_TURN_ALL);
    /* and a hundredth of what is above */
    assert_true(fabs(problem.body[1].v[2] - (0.01 + HARD_RELEASE_PART * (-problem.row[0].bias - 0.01))) <
                1e-15);
    hard_problem_free(&problem);
}

/* An overlap is released within a bounded speed, and the impulse that does it counts in Coulomb's limit: a sphere between a floor at rest and
 * a belt, into both of which it is pressed, is dragged by friction x the whole impulse of each, and rests if these are equal. */
static void test_repair(void **state) {
    (void)state;
    const double bound = 0.01, friction = 0.3;
    struct hard_problem problem;
    for (int belt = 0; belt < 2; belt++) { /* 1: the wall above moves along x */
        problem_begin(&problem, 3, 2);
        problem.body[0] = (struct hard_body){0};
        problem.body[1] = sphere(2.0, 1.0, (double[3]){0, 0, 0});
        problem.body[2] = (struct hard_body){.v = {belt ? 5.0 : 0.0, 0, 0}};
        for (uint32_t k = 0; k < 2; k++) {
            struct hard_row *row = &problem.row[k];
            *row = contact(problem.body, k, k + 1, HARD_KAPPA);
            row->lever[k ? 1 : 0] = 0.0;
            row->gap = k ? -0.02 * step : -0.5 * step; /* deeper in the floor */
            row->bias = row->gap / step;
            row->release = bound;
            row->friction = friction;
        }
        for (int sweep = 0; sweep < 2000; sweep++)
            hard_problem_sweep(&problem, HARD_TURN_ALL);
        const struct hard_row *floor = &problem.row[0], *lid = &problem.row[1];
        assert_true(residual(&problem) < 1e-12);
        assert_true(floor->p > 1e-3 && lid->p > 1e-3);
        assert_true(problem.body[1].v[2] > 0.0 &&
                    problem.body[1].v[2] <= bound + HARD_RELEASE_PART * 0.5); /* out of the floor */
        for (int k = 0; k < 2; k++) {
            const struct hard_row *row = &problem.row[k];
            assert_true(sqrt(vector_dot(row->q, row->q)) <= friction * row->p * (1.0 + 1e-12));
        }
        if (belt) /* the belt slides: its friction is that of all of its impulse, that of the repair, too */
            assert_true(fabs(lid->q[0] / (friction * lid->p) + 1.0) < 1e-12);
        hard_problem_free(&problem);
    }
}

/* The overlap that a visit of Hertz finds is the root, whatever overlap the last visit has left, for soft and for very stiff contacts. */
static void test_hertz_begin(void **state) {
    (void)state;
    const double from[] = {0.0, 1e-15, 1e-9, 1e-5, 1e-3, 10.0};
    const double dt = 1e-3, a = 2.0, free = -0.3;
    for (double hertz = 1e-3; hertz < 1e13; hertz *= 100.0)
        for (size_t k = 0; k < sizeof from / sizeof *from; k++) {
            struct hard_row row = {.gap = -1e-5, .hertz = hertz, .deep = from[k]};
            double p = hard_hertz(&row, dt, a, free), goal = -(row.gap + dt * free);
            assert_near(row.deep + a * dt * hertz * row.deep * sqrt(row.deep), goal, 1e-14 * goal);
            assert_near(p, hertz * row.deep * sqrt(row.deep), 1e-14 * p);
        }
}

/* The force of a row of Hertz is that of its overlap at the end of the step. */
static void test_hertz(void **state) {
    (void)state;
    struct hard_problem problem;
    single_make(&problem, 1.0, (double[3]){0, 0, -0.5});
    problem.row[0].hertz = 1e7 * step;
    problem.row[0].gap = -1e-5;
    hard_problem_sweep(&problem, HARD_TURN_ALL);
    double overlap = 1e-5 - step * problem.body[1].v[2];
    assert_true(overlap > 0.0);
    assert_true(fabs(problem.row[0].p / (step * 1e7 * overlap * sqrt(overlap)) - 1.0) < 1e-12);
    assert_true(fabs(problem.row[0].p - (problem.body[1].v[2] + 0.5)) < 1e-15);
    hard_problem_free(&problem);
}

/* A linear row with a damper: its force is k y + c u of the overlap y at the end of the step, and its spring holds k y^2 / 2. */
static void test_damper(void **state) {
    (void)state;
    const double k = 1e5, c = 30.0;
    struct hard_problem problem;
    single_make(&problem, 1.0, (double[3]){0, 0, -0.5});
    struct hard_row *row = &problem.row[0];
    row->gap = -1e-5;
    row->soft_n = 1.0 / (step * (k * step + c));
    row->damper = step * c;
    row->bias = row->gap / (step + c / k);
    hard_problem_sweep(&problem, HARD_TURN_ALL);
    double u = problem.body[1].v[2], overlap = -row->gap - step * u, stored[2];
    hard_stored(row, step, step, stored);
    assert_true(overlap > 0.0 && row->p > 0.0);
    assert_true(fabs(row->p / (step * (k * overlap - c * u)) - 1.0) < 1e-12);
    assert_true(fabs(stored[0] / (0.5 * k * overlap * overlap) - 1.0) < 1e-12);
    hard_problem_free(&problem);
}

static double energy(const struct hard_body *b) {
    return 0.5 * vector_dot(b->v, b->v) / b->lightness + 0.5 * vector_dot(b->w, b->w) / b->swing;
}

/* 400 oblique impacts: restitution of the normal velocity, Coulomb's limit of the tangential impulse, no gain of energy,
 * momentum to rounding. */
static void test_impacts(void **state) {
    (void)state;
    for (uint64_t k = 0; k < 400; k++) {
        struct random_sequence random = random_sequence(17, RANDOM_TEST, k);
        struct hard_problem problem;
        problem_begin(&problem, 2, 1);
        for (int b = 0; b < 2; b++) {
            double v[3];
            for (int d = 0; d < 3; d++)
                v[d] = 2.0 * random_uniform(&random) - 1.0;
            v[2] += b ? -2.0 : 2.0;
            problem.body[b] = sphere(0.1 + random_uniform(&random), 1.0, v);
            for (int d = 0; d < 3; d++)
                problem.body[b].w[d] = 4.0 * random_uniform(&random) - 2.0;
        }
        struct hard_row *row = &problem.row[0];
        *row = contact(problem.body, 0, 1, INFINITY);
        row->friction = 0.5 * random_uniform(&random);
        row->restitution = random_uniform(&random);
        row->impact = true;
        double u[3], before = energy(&problem.body[0]) + energy(&problem.body[1]), momentum[2];
        hard_velocity(row, &problem.body[0], &problem.body[1], u);
        row->approach = -u[2];
        momentum[0] = problem.body[0].v[0] / problem.body[0].lightness +
                      problem.body[1].v[0] / problem.body[1].lightness;
        hard_problem_sweep(&problem, HARD_TURN_ALL);
        for (int sweep = 0; sweep < 8; sweep++)
            hard_problem_rebound(&problem, HARD_TURN_ALL);
        hard_velocity(row, &problem.body[0], &problem.body[1], u);
        momentum[1] = problem.body[0].v[0] / problem.body[0].lightness +
                      problem.body[1].v[0] / problem.body[1].lightness;
        assert_true(fabs(u[2] - row->restitution * row->approach) < 1e-13);
        assert_true(fabs(momentum[1] - momentum[0]) < 1e-13);
        double rub = sqrt(vector_dot(row->q, row->q)), slip = hypot(u[0], u[1]);
        assert_true(slip < 1e-12 || fabs(rub / (row->friction * row->p) - 1.0) < 1e-12);
        assert_true(rub <= row->friction * row->p * (1.0 + 1e-12));
        assert_true(energy(&problem.body[0]) + energy(&problem.body[1]) <= before * (1.0 + 1e-13));
        hard_problem_free(&problem);
    }
}

enum { PARTICLES = 300, PAIRS = 1201 };

/* Particle 0 meets all others, and each of those its next four; pair k is number (stride k) of the list. */
static void pairs_make(uint32_t (*end)[2], uint8_t *image, size_t stride) {
    const uint32_t others = PARTICLES - 1;
    for (uint32_t k = 0; k < PAIRS; k++) {
        size_t at = k * stride % PAIRS;
        uint32_t more = k - others, a = more % others;
        end[at][0] = k < others ? 0 : 1 + a;
        end[at][1] = k < others ? k + 1 : 1 + (a + 1 + more / others) % others;
        image[at] = 0;
    }
}

/* No two cuts of a colour share a particle, unless they are one cut; colours do not depend on the order of the list. */
static void test_colours(void **state) {
    (void)state;
    static uint32_t end[PAIRS][2];
    static uint8_t image[PAIRS];
    static int64_t id[PARTICLES];
    static int seen[PARTICLES], colour_of[2][PAIRS];
    const size_t strides[2] = {1, 7};
    for (int k = 0; k < PARTICLES; k++)
        id[k] = (k * 7919) % 30011 + 1;
    for (int turn = 0; turn < 2; turn++) {
        struct hard_colours colours;
        size_t count = 0;
        pairs_make(end, image, strides[turn]);
        hard_colours_make(&colours, PAIRS, (const uint32_t(*)[2])end, image, NULL, PARTICLES, id);
        for (int c = 0; c < colours.colours; c++) {
            memset(seen, 0, sizeof seen);
            for (size_t k = colours.colour[c]; k < colours.colour[c + 1]; k++)
                for (size_t m = colours.cut[k]; m < colours.cut[k + 1]; m++, count++)
                    for (int e = 0; e < 2; e++) {
                        int *mark = &seen[end[colours.order[m]][e]];
                        assert_true(*mark == 0 || *mark == (int)k + 1);
                        *mark = (int)k + 1;
                        colour_of[turn][colours.order[m]] = c;
                    }
        }
        assert_int_equal(count, PAIRS);
        assert_true(colours.colours < 50);
        hard_colours_free(&colours);
    }
    for (size_t k = 0; k < PAIRS; k++)
        assert_int_equal(colour_of[0][k], colour_of[1][k * 7 % PAIRS]);
}

TEST_MAIN(hard, cmocka_unit_test(test_chain_rigid), cmocka_unit_test(test_chain_soft),
          cmocka_unit_test(test_chain_warm), cmocka_unit_test(test_heavy), cmocka_unit_test(test_single),
          cmocka_unit_test(test_gap), cmocka_unit_test(test_repair), cmocka_unit_test(test_hertz),
          cmocka_unit_test(test_hertz_begin), cmocka_unit_test(test_damper), cmocka_unit_test(test_impacts),
          cmocka_unit_test(test_colours))
