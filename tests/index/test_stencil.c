/* SPDX-License-Identifier: BSD-3-Clause */
/* The parts below the indexes: frames, grids, stencils, against their definitions. */
#include "tests/test.h"

#include "base/random.h"
#include "index/grids/grid_frame.h"
#include "index/grids/grid.h"
#include "index/grids/stencil.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 400 };

static struct index_view view_of(double (*x)[4], bool periodic) {
    struct index_view view = {.owned = POINTS / 2,
                              .total = POINTS,
                              .position = x[0],
                              .radius = x[0] + 3,
                              .stride = 4,
                              .dimension = 3,
                              .edge = {37, 5, 11},
                              .periodic = {periodic, periodic, periodic},
                              .classes = 1,
                              .radius_max = {0.9},
                              .margin = {{0.2}},
                              .threads = 1};
    struct random_sequence random = random_sequence(5, RANDOM_TEST, periodic);
    for (int k = 0; k < POINTS; k++) {
        for (int d = 0; d < 3; d++) {
            x[k][d] = random_uniform(&random) * view.edge[d] * (k >= POINTS / 2 && !periodic ? 1.7 : 1);
        }
        x[k][3] = 0.9;
    }
    return view;
}

/* Distances in the frame, images included, deviate by no more than the tolerance of the frame. */
static void frames_keep_distances(void **state) {
    (void)state;
    double x[POINTS][4];
    for (int periodic = 0; periodic < 2; periodic++) {
        struct index_view view = view_of(x, periodic);
        struct frame frame;
        grid_frame_make(&frame, &view);
        assert_true(frame.tolerance > 0 && frame.tolerance < 1e-3);
        for (int k = 0; k < POINTS * POINTS; k++) {
            const double *a = x[k % POINTS], *b = x[k / POINTS];
            int image = periodic ? k % 3 - 1 : 0;
            double exact = 0, rounded = 0;
            for (int d = 0; d < 3; d++) {
                double dx = (b[d] - a[d] + image * view.edge[d]) * frame.scale;
                float shifted = grid_frame_coordinate(&frame, d, b[d]) + (float)image * frame.edge[d];
                float df = shifted - grid_frame_coordinate(&frame, d, a[d]);
                exact += dx * dx;
                rounded += (double)df * df;
            }
            assert_true(fabs(sqrt(exact) - sqrt(rounded)) <= frame.tolerance);
        }
    }
}

/* An open frame ends where its particles end: no particle is clamped, and no cell lies beyond. */
static void frames_end_where_particles_end(void **state) {
    (void)state;
    double x[POINTS][4];
    struct index_view view = view_of(x, false);
    struct frame frame;
    grid_frame_make(&frame, &view);
    assert_false(frame.clamped);
    for (int d = 0; d < 3; d++) {
        float low = INFINITY, high = -INFINITY, owned = -INFINITY;
        for (size_t k = 0; k < POINTS; k++) {
            assert_true(grid_frame_holds(&frame, d, x[k][d]));
            float at = grid_frame_coordinate(&frame, d, x[k][d]);
            low = fminf(low, at);
            high = fmaxf(high, at);
            owned = k < view.owned ? high : owned;
        }
        assert_true(frame.all_low[d] == low && frame.all_high[d] == high && frame.owned_high[d] == owned);
    }
}

/* A point between two points lies in a cell between their cells; every particle has a cell. */
static void cells_ascend(void **state) {
    (void)state;
    double x[POINTS][4];
    for (int periodic = 0; periodic < 2; periodic++) {
        struct index_view view = view_of(x, periodic);
        struct frame frame;
        struct grid grid;
        grid_frame_make(&frame, &view);
        grid_make(&grid, &frame, 0.77, 0.31);
        assert_true(grid.cells == (double)grid.n[0] * grid.n[1] * grid.n[2]);
        for (int d = 0; d < 3; d++) {
            assert_true(grid.n[d] > 3);
            int lowest = grid.n[d], highest = -1;
            for (int k = 0; k < POINTS; k++) {
                float a = grid_frame_coordinate(&frame, d, x[k][d]);
                float b = grid_frame_coordinate(&frame, d, x[(k + 1) % POINTS][d]);
                int ca = grid_cell(&grid, d, a), cb = grid_cell(&grid, d, b);
                assert_true(ca >= 0 && ca < grid.n[d]);
                assert_true(a < b ? ca <= cb : ca >= cb);
                assert_true(fabs((double)(ca - cb) * grid.size[d] - (a - b)) < 1.001 * grid.size[d]);
                lowest = ca < lowest ? ca : lowest;
                highest = ca > highest ? ca : highest;
            }
            assert_true(lowest <= 2 && highest >= grid.n[d] - 3);
        }
    }
}

static bool stencil_has(const struct stencil *stencil, int dx, int dy, int dz) {
    for (size_t k = 0; k < stencil->count; k++) {
        if (stencil->run[k].dy == dy && stencil->run[k].dz == dz) {
            return abs(dx) <= stencil->run[k].dx;
        }
    }
    return false;
}

/* Any two points within the reach are in cells that the stencil joins; cells well beyond the reach are left out. */
static void stencils_cover_the_reach(void **state) {
    (void)state;
    double x[POINTS][4];
    struct index_view view = view_of(x, false);
    struct frame frame;
    struct grid grid;
    grid_frame_make(&frame, &view);
    for (double edge = 0.4; edge < 5; edge *= 1.7) {
        struct stencil stencil = {0};
        grid_make(&grid, &frame, edge, edge / 2);
        float reach = 1.3f;
        assert_true(stencil_make(&stencil, &grid, &frame, reach, 1 << 20));
        assert_true(stencil.run[stencil.middle].dy == 0 && stencil.run[stencil.middle].dz == 0);
        for (int k = 0; k < POINTS * POINTS; k++) {
            int apart[3];
            double square = 0, gap = 0;
            for (int d = 0; d < 3; d++) {
                float a = grid_frame_coordinate(&frame, d, x[k % POINTS][d]);
                float b = grid_frame_coordinate(&frame, d, x[k / POINTS][d]);
                apart[d] = grid_cell(&grid, d, b) - grid_cell(&grid, d, a);
                square += ((double)b - a) * ((double)b - a);
                gap += pow(fmax(0, (abs(apart[d]) - 2) * grid.size[d]), 2);
            }
            bool has = stencil_has(&stencil, apart[0], apart[1], apart[2]);
            assert_true(has || square > (double)reach * reach);
            assert_true(!has || gap <= (double)reach * reach * 1.01);
        }
        assert_false(stencil_make(&stencil, &grid, &frame, reach, 0));
        stencil_free(&stencil);
    }
}

/* Positions that are not numbers, or infinite, do not widen the frame and are noticed. */
static void frames_survive_nonsense(void **state) {
    (void)state;
    double x[POINTS][4];
    struct index_view view = view_of(x, false);
    x[3][0] = NAN;
    x[7][1] = INFINITY;
    x[9][2] = -1e300;
    struct frame frame;
    grid_frame_make(&frame, &view);
    assert_true(frame.tolerance < 1e-2f &&
                isfinite(frame.all_high[0] + frame.all_high[1] + frame.all_low[2]));
    assert_false(grid_frame_holds(&frame, 0, x[3][0]));
    assert_false(grid_frame_holds(&frame, 1, x[7][1]));
    assert_false(grid_frame_holds(&frame, 2, x[9][2]));
    assert_true(grid_frame_holds(&frame, 0, x[4][0]));
}

TEST_MAIN(stencil, cmocka_unit_test(frames_keep_distances), cmocka_unit_test(frames_end_where_particles_end),
          cmocka_unit_test(cells_ascend), cmocka_unit_test(stencils_cover_the_reach),
          cmocka_unit_test(frames_survive_nonsense))
