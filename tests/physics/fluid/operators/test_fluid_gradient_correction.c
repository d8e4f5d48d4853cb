/* SPDX-License-Identifier: BSD-3-Clause */
/* The correction of gradients beside a plane: linear pressures have their exact gradient, and closed pores the bound of the eigenvalues. */
#include "tests/test.h"

#include <math.h>

#include "base/memory.h"
#include "tests/physics/fluid/fluid_cloud.h"
#include "tests/near.h"
#include "physics/fluid/lattice/mirror.h"
#include "physics/fluid/operators/gradient_correction.h"

static bool open_side;

static void plane(const void *context, int64_t wall, const double x[3], struct weights_foot *foot) {
    (void)context, (void)wall;
    *foot = (struct weights_foot){.distance = x[2] - 0.3, .normal = {0, 0, 1}, .open = open_side};
}

struct room {
    struct fluid_cloud cloud;
    struct weights weights;
    uint8_t *kind;
    int64_t *body;
    size_t fluid;
    double (*whole)[9];
};

static void room_make(struct room *r, bool open) {
    open_side = open;
    r->fluid = fluid_cloud_plane(&r->cloud, 0.3, &r->kind, &r->body);
    r->weights = fluid_cloud_weigh(&r->cloud, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    struct mirror_input input = {
        .rows = &r->cloud.input, .body = r->body, .spacing = r->cloud.spacing, .wall = plane};
    assert_int_equal(mirror_make(&r->weights, &input), 0);
    r->whole = memory_allocate(r->cloud.particles->owned, sizeof *r->whole, "test");
    gradient_correction_make(&r->weights, &r->cloud.input, r->whole);
}

static void room_free(struct room *r) {
    memory_free(r->whole);
    memory_free(r->kind);
    memory_free(r->body);
    weights_free(&r->weights);
    fluid_cloud_free(&r->cloud);
}

/* C times sum over the fluid neighbours of b_ij g . (x_j - x_i), which is g. */
static void a_linear_pressure_has_its_gradient(void **state) {
    static const double slope[3] = {0.7, -1.2, 2.1};
    struct room r;
    int closed = 0;
    (void)state;
    room_make(&r, false);
    r.weights.whole = r.whole;
    for (size_t row = 0; row < r.fluid; row++) {
        double seen[3] = {0}, apart[3], gradient[3];
        for (size_t e = r.weights.start[row]; e < weights_walls(&r.weights, row); e++) {
            double rise = 0;
            weights_apart(&r.weights, &r.cloud.input, row, e, apart);
            for (int d = 0; d < 3; d++)
                rise += slope[d] * apart[d];
            for (int d = 0; d < 3; d++)
                seen[d] += weights_vector(&r.weights, e)[d] * rise;
        }
        closed += fabs(seen[2] - slope[2]) > 0.1;
        weights_whole(&r.weights, r.weights.first + row, seen, gradient);
        for (int d = 0; d < 3; d++)
            assert_near(gradient[d], slope[d], 1e-10);
    }
    assert_true(closed >= 200);
    room_free(&r);
}

/* Beside a plane C is diagonal, the inverse of what is seen in each direction; by an open side, and far from both, C is 1. */
static void c_is_that_of_the_plane(void **state) {
    (void)state;
    for (int open = 0; open < 2; open++) {
        struct room r;
        room_make(&r, open);
        for (size_t row = 0; row < r.fluid; row++) {
            double seen[3] = {1, 1, 1}, apart[3];
            for (size_t e = weights_walls(&r.weights, row); e < r.weights.start[row + 1]; e++) {
                weights_apart(&r.weights, &r.cloud.input, row, e, apart);
                for (int d = 0; d < 3; d++)
                    seen[d] -= open ? 0 : weights_vector(&r.weights, e)[d] * apart[d];
            }
            assert_near(seen[0], seen[1], 1e-12);
            for (int d = 0; d < 9; d++)
                assert_near(r.whole[r.weights.first + row][d], d % 4 == 0 ? 1 / seen[d / 3] : 0, 1e-10);
        }
        room_free(&r);
    }
}

/* A particle whose neighbours are all beyond the plane sees nothing of a gradient: C is 1 / WHOLE_LEAST across. */
static void a_closed_pore_has_the_bound(void **state) {
    struct room r;
    (void)state;
    room_make(&r, false);
    struct weights alone = r.weights;
    size_t start[2] = {r.weights.start[0], r.weights.start[1]}, walls[2] = {0, start[1] - start[0]};
    uint32_t *foot = memory_allocate_zero(walls[1], sizeof *foot, "test");
    alone.rows = 1;
    alone.start = start;
    alone.wall_start = walls;
    alone.wall_foot = foot;
    gradient_correction_make(&alone, &r.cloud.input, r.whole);
    for (int d = 0; d < 9; d++)
        assert_near(r.whole[alone.first][d], d % 4 == 0 ? 1 / WHOLE_LEAST : 0, 1e-9);
    memory_free(foot);
    room_free(&r);
}

TEST_MAIN(fluid_gradient_correction, cmocka_unit_test(a_linear_pressure_has_its_gradient),
          cmocka_unit_test(c_is_that_of_the_plane), cmocka_unit_test(a_closed_pore_has_the_bound))
