/* SPDX-License-Identifier: BSD-3-Clause */
/* Cohesion of hard contacts as a given pull, against closed forms (src/physics/hard/row.h). */
#include "tests/test.h"

#include "base/random.h"
#include "physics/hard/models.h"
#include "physics/hard/problem.h"
/* after setjmp.h and stdarg.h */
#include "tests/near.h"

enum { CASES = 300 };
static const double dt = 1e-3, gravity = 10.0, mass = 2.0;

/* A plate (body 0) and a sphere of radius 1 (body 1) that touch; the normal points from the plate to the sphere. `pull`: force. */
static void single_make(struct hard_problem *problem, const double normal[3], double pull) {
    *problem = (struct hard_problem){0};
    hard_problem_reserve(problem, 2, 1, 1);
    hard_problem_begin(problem, dt);
    problem->bodies = 2;
    problem->rows = 1;
    problem->cut[++problem->cuts] = 1;
    hard_problem_end_colour(problem);
    problem->body[0] = (struct hard_body){0};
    problem->body[1] = (struct hard_body){.lightness = 1.0 / mass, .swing = 2.5 / mass};
    problem->row[0] = (struct hard_row){.body = {0, 1},
                                        .normal = {normal[0], normal[1], normal[2]},
                                        .lever = {0, 1},
                                        .release = INFINITY,
                                        .pull = pull * dt,
                                        .press = pull * dt};
}

static double residual(const struct hard_problem *problem) {
    double sum[3];
    hard_problem_residual(problem, sum);
    return sum[1] > 0.0 || sum[2] > 0.0 ? sqrt(sum[0] / fmax(sum[1], sum[2])) : 0.0;
}

/* A sphere hangs below a plate as long as its weight is below the pull; the contact has what is left of it. */
static void test_hangs(void **state) {
    (void)state;
    for (int heavy = 0; heavy < 2; heavy++) {
        struct hard_problem problem;
        double pull = mass * gravity * (heavy ? 0.99 : 1.01);
        single_make(&problem, (double[3]){0, 0, -1}, pull);
        problem.body[1].v[2] = -gravity * dt;
        hard_problem_pull(&problem);
        hard_problem_warm(&problem);
        hard_problem_sweep(&problem, HARD_TURN_ALL);
        const struct hard_row *row = &problem.row[0];
        assert_near(row->p, heavy ? 0.0 : 0.01 * mass * gravity * dt, 1e-15);
        assert_near(problem.body[1].v[2], heavy ? -0.01 * gravity * dt : 0.0, 1e-15);
        assert_near(residual(&problem), 0.0, 1e-12);
        double impulse[6];
        hard_impulse(row, 1, impulse); /* what the plate gives the sphere, with the pull */
        assert_near(impulse[2], heavy ? pull * dt : mass * gravity * dt, 1e-15);
        hard_problem_free(&problem);
    }
}

/* Friction's limit on a slope is friction x (the normal impulse, in which the pull is, and what the law adds): a body that does not turn holds up to
 * tan = friction (1 + 2 pull / weight). */
static void test_slope(void **state) {
    (void)state;
    const double friction = 0.3, part = 0.5, most = friction * (1.0 + 2.0 * part);
    for (int steep = 0; steep < 2; steep++) {
        struct hard_problem problem;
        double tangent = most * (steep ? 1.01 : 0.99);
        single_make(&problem, (double[3]){0, 0, 1}, part * mass * gravity);
        problem.body[1].swing = 0.0;
        problem.body[1].v[0] = tangent * gravity * dt;
        problem.body[1].v[2] = -gravity * dt;
        problem.row[0].friction = friction;
        hard_problem_pull(&problem);
        hard_problem_sweep(&problem, HARD_TURN_ALL);
        assert_near(problem.row[0].p, (1.0 + part) * mass * gravity * dt, 1e-15);
        assert_near(problem.body[1].v[0], steep ? 0.01 * most * gravity * dt : 0.0, 1e-15);
        assert_near(problem.body[1].v[2], 0.0, 1e-15);
        hard_problem_free(&problem);
    }
}

/* At rest the spring holds the pull, and the energy of the cohesion is minus the pull times the overlap. */
static void test_energy(void **state) {
    (void)state;
    const double pull = 30.0, k = 1e6;
    struct hard_problem problem;
    double stored[2];
    single_make(&problem, (double[3]){0, 0, 1}, pull);
    struct hard_row *row = &problem.row[0];
    row->soft_n = 1.0 / (k * dt * dt);
    row->gap = -pull / k;
    row->bias = row->gap / dt;
    hard_problem_pull(&problem);
    hard_problem_sweep(&problem, HARD_TURN_ALL);
    assert_near(row->p, pull * dt, 1e-14);
    assert_near(problem.body[1].v[2], 0.0, 1e-15);
    hard_stored(row, dt, dt, stored);
    assert_near(stored[0], -0.5 * pull * pull / k, 1e-15);
    hard_problem_free(&problem);
}

/* A contact whose normal and tangents are coupled. */
static struct hard_local local_make(uint64_t number) {
    struct random_sequence random = random_sequence(43, RANDOM_TEST, number);
    struct hard_local local = {.friction = 0.05 + 0.45 * random_uniform(&random),
                               .press = random_uniform(&random)};
    double j[9];
    for (int k = 0; k < 9; k++)
        j[k] = 1.2 * random_uniform(&random) - 0.6;
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            local.a[3 * a + b] = a == b ? 1.0 : 0.0;
            for (int k = 0; k < 3; k++)
                local.a[3 * a + b] += j[3 * k + a] * j[3 * k + b];
        }
    local.c[0] = 2.0 * random_uniform(&random) - 1.5;
    local.c[1] = 4.0 * random_uniform(&random) - 2.0;
    local.c[2] = 4.0 * random_uniform(&random) - 2.0;
    return local;
}

/* It pushes or opens, and sticks, or slides against the slip at friction's limit. */
static void law_holds(const struct hard_local *l, const double p[3], double tolerance) {
    double w[3], most = l->friction * (p[0] + l->press), rub = hypot(p[1], p[2]);
    for (int d = 0; d < 3; d++)
        w[d] = l->c[d] + l->a[3 * d] * p[0] + l->a[3 * d + 1] * p[1] + l->a[3 * d + 2] * p[2];
    double slip = hypot(w[1], w[2]);
    assert_true(p[0] >= 0.0 && w[0] >= -tolerance && p[0] * w[0] <= tolerance);
    assert_true(rub <= most + tolerance);
    if (slip > tolerance) {
        assert_near(rub, most, tolerance);
        assert_near(p[1] * w[1] + p[2] * w[2], -rub * slip, tolerance);
    }
}

/* The models of Coulomb's law obey it with a cohesion, too; the others stay within friction's limit. */
static void test_models(void **state) {
    (void)state;
    for (uint64_t k = 0; k < CASES; k++) {
        const struct hard_local l = local_make(k);
        for (int m = 0; m < HARD_MODELS; m++) {
            double p[3] = {0.0, 0.0, 0.0};
            hard_relax_model((enum hard_model_number)m)->relax(&l, p);
            if (m == HARD_MODEL_COULOMB || m == HARD_MODEL_DE_SAXCE)
                law_holds(&l, p, m == HARD_MODEL_COULOMB ? 1e-9 : 1e-7);
            assert_true(p[0] >= 0.0 && hypot(p[1], p[2]) <= l.friction * (p[0] + l.press) * (1.0 + 1e-9));
        }
    }
}

TEST_MAIN(pull, cmocka_unit_test(test_hangs), cmocka_unit_test(test_slope), cmocka_unit_test(test_energy),
          cmocka_unit_test(test_models))
