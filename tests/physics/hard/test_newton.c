/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows and the preconditioner of Newton's method for hard contacts (src/physics/hard/newton_row.h, newton_blocks.h). */
#include "tests/test.h"

#include "physics/hard/newton_blocks.h"
#include <string.h>
/* after setjmp.h and stdarg.h */
#include "tests/near.h"

enum { SPHERES = 12 };
static const double dt = 1e-3;

static struct hard_row row_make(void) {
    struct hard_row row = {.body = {0, 1},
                           .normal = {0.6, 0.0, 0.8},
                           .lever = {1, 2},
                           .bias = -0.3,
                           .soft_n = 0.5,
                           .soft_t = 0.7,
                           .release = 0.2,
                           .friction = 0.4,
                           .hold = {0.08, 0.05, -0.06}};
    return row;
}

/* The derivative is that of the impulses. */
static void derivative_holds(const struct hard_row *row, const double u[3]) {
    struct hard_newton_row newton, other;
    const double h = 1e-7;
    double p[2], q[2][3];
    hard_newton_at(row, &newton, dt, 1.0, u, &p[0], q[0]);
    for (int k = 0; k < 3; k++) {
        double du[3] = {0.0, 0.0, 0.0}, answer[3];
        du[k] = 1.0;
        hard_newton_answer(row, &newton, du, answer);
        for (int s = 0; s < 2; s++) {
            double moved[3] = {u[0], u[1], u[2]};
            moved[k] += s ? h : -h;
            hard_newton_at(row, &other, dt, 1.0, moved, &p[s], q[s]);
        }
        for (int d = 0; d < 3; d++) {
            double slope = (p[0] - p[1]) * row->normal[d] + (q[0][d] - q[1][d]);
            assert_near(answer[d], slope / (2.0 * h), 1e-5 * (1.0 + fabs(answer[d])));
        }
    }
}

static void test_derivative(void **state) {
    (void)state;
    struct hard_row row = row_make();
    const double sticks[3] = {0.02, 0.01, -0.03}, slides[3] = {0.4, 0.3, -0.5}, opens[3] = {0.4, 0.1, 0.6},
                 leaves[3] = {0.12, 0.0, 0.1601};
    const double *u[] = {sticks, slides, opens, leaves};
    for (int k = 0; k < 8; k++) {
        row.press = k < 4 ? 0.0 : 0.1; /* with a cohesion */
        derivative_holds(&row, u[k % 4]);
    }
    row.hertz = 40.0;
    row.damper = 0.05;
    row.gap = -1e-2;
    row.shear = 30.0;
    row.deep = 1e-2;
    derivative_holds(&row, sticks);
    derivative_holds(&row, slides);
}

/* At the impulse that visits end with, the function of the velocity gives the same: both have one solution. */
static void agrees(struct hard_row row, double mass) {
    struct hard_body body[2] = {{.v = {0.1, 0.2, 0.3}, .lightness = 1.0 / mass, .swing = 0.1},
                                {.v = {-0.3, 0.1, -0.2}, .lightness = 2.0, .swing = 0.2}};
    struct hard_newton_row newton;
    double p, q[3], u[3];
    for (int k = 0; k < 200; k++)
        hard_visit(&row, dt, &body[0], &body[1]);
    hard_velocity(&row, &body[0], &body[1], u);
    hard_newton_at(&row, &newton, dt, hard_slide(&row, &body[0], &body[1]), u, &p, q);
    assert_near(p, row.p, 1e-9 * (1.0 + row.p));
    for (int d = 0; d < 3; d++)
        assert_near(q[d], row.q[d], 1e-9 * (1.0 + row.p));
}

static void test_solution(void **state) {
    (void)state;
    struct hard_row row = row_make();
    agrees(row, 1.0);
    agrees(row, 1e3);
    row.press = 0.3;
    agrees(row, 1.0);
    row.bias = -50.0; /* the speed of release is met */
    agrees(row, 1.0);
    row.soft_t = 0.0;
    agrees(row, 1.0);
    row = row_make();
    row.hertz = 40.0;
    row.damper = 0.05;
    row.shear = 30.0;
    row.gap = -1e-2;
    agrees(row, 1.0);
    row.gap = 1e-5; /* closes within the step */
    agrees(row, 1.0);
}

/* y = x + S Jt G J S x by the rows. */
static void product(const struct hard_problem *problem, const struct hard_newton_row *newton,
                    const double (*x)[6], double (*y)[6]) {
    memcpy(y, x, SPHERES * sizeof *y);
    for (size_t r = 0; r < problem->rows; r++) {
        const struct hard_row *row = &problem->row[r];
        struct hard_body way[2] = {0}, sum[2];
        double du[3], out[3];
        for (int e = 0; e < 2; e++) {
            const struct hard_body *body = &problem->body[row->body[e]];
            for (int d = 0; d < 3 && row->body[e] < SPHERES; d++) {
                way[e].v[d] = sqrt(body->lightness) * x[row->body[e]][d];
                way[e].w[d] = sqrt(body->swing) * x[row->body[e]][3 + d];
            }
            sum[e] = (struct hard_body){.lightness = sqrt(body->lightness), .swing = sqrt(body->swing)};
        }
        hard_velocity(row, &way[0], &way[1], du);
        hard_newton_answer(row, &newton[r], du, out);
        hard_apply(row, &sum[0], &sum[1], 0.0, out);
        for (int e = 0; e < 2; e++)
            for (int d = 0; d < 3 && row->body[e] < SPHERES; d++) {
                y[row->body[e]][d] += sum[e].v[d];
                y[row->body[e]][3 + d] += sum[e].w[d];
            }
    }
}

/* The factor of a chain on a floor has no fill: it is exact. */
static void test_chain(void **state) {
    (void)state;
    struct hard_problem problem = {0};
    struct hard_newton_row newton[SPHERES];
    struct hard_blocks blocks = {0};
    struct hard_border border = {0};
    double x[SPHERES][6], y[SPHERES][6], z[SPHERES][6];
    hard_problem_reserve(&problem, SPHERES + 1, SPHERES, SPHERES);
    hard_problem_begin(&problem, dt);
    problem.bodies = SPHERES + 1;
    problem.rows = SPHERES;
    for (uint32_t k = 0; k <= SPHERES; k++)
        problem.body[k] =
            k < SPHERES ? (struct hard_body){.lightness = 1.0 + k, .swing = 2.0 + k} : (struct hard_body){0};
    for (uint32_t k = 0; k < SPHERES; k++) {
        problem.row[k] = row_make();
        problem.row[k].body[0] = k ? k - 1 : SPHERES;
        problem.row[k].body[1] = k;
        double p, q[3];
        problem.row[k].friction = k % 2 ? 0.0 : 10.0;
        hard_newton_at(&problem.row[k], &newton[k], dt, 1.0, (double[3]){0.4, 0.1, -0.5}, &p, q);
    }
    problem.cut[++problem.cuts] = SPHERES;
    hard_problem_end_colour(&problem);
    for (int k = 0; k < SPHERES; k++)
        for (int d = 0; d < 6; d++)
            x[k][d] = sin(7.0 * k + d);
    product(&problem, newton, (const double(*)[6])x, y);
    hard_blocks_shape(&blocks, &problem, SPHERES);
    hard_blocks_make(&blocks, &problem, newton, &border);
    hard_blocks_solve(&blocks, (const double(*)[6])y, z);
    for (int k = 0; k < SPHERES; k++)
        for (int d = 0; d < 6; d++)
            assert_near(z[k][d], x[k][d], 1e-10);
    hard_blocks_free(&blocks);
    hard_problem_free(&problem);
}

TEST_MAIN(newton, cmocka_unit_test(test_derivative), cmocka_unit_test(test_solution),
          cmocka_unit_test(test_chain))
