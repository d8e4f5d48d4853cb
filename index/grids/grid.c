/* SPDX-License-Identifier: BSD-3-Clause */
/* Lays a grid into the frame, for open and for periodic directions. Read grid.h first. */
#include "index/grids/grid.h"

#include <math.h>

enum { CELLS_ACROSS = 1 << 20 };

static void periodic_direction(struct grid *grid, const struct frame *frame, int d, double edge) {
    double extent = (double)frame->edge[d] * frame->unit;
    double n = floor(fmin(extent / edge, CELLS_ACROSS));
    n = fmax(n, 1);
    grid->n[d] = (int)n;
    grid->anchor[d] = frame->all_low[d];
    grid->inverse[d] = (float)(n / ((double)frame->all_high[d] - frame->all_low[d]));
    grid->base[d] = 0;
    grid->top[d] = (float)(n - 1);
}

static void open_direction(struct grid *grid, const struct frame *frame, int d, double edge) {
    double extent = ((double)frame->all_high[d] - frame->all_low[d]) * frame->unit;
    edge = fmax(edge, extent / CELLS_ACROSS);
    grid->anchor[d] = frame->owned_low[d];
    grid->inverse[d] = (float)(frame->unit / edge);
    float low = (frame->all_low[d] - grid->anchor[d]) * grid->inverse[d];
    float high = (frame->all_high[d] - grid->anchor[d]) * grid->inverse[d];
    grid->base[d] = floorf(low);
    grid->top[d] = floorf(high);
    grid->n[d] = (int)(grid->top[d] - grid->base[d]) + 1;
}

void grid_make(struct grid *grid, const struct frame *frame, double edge, double x_edge) {
    *grid = (struct grid){.edge = edge, .cells = 1};
    for (int d = 0; d < 3; d++) {
        if (frame->periodic[d]) {
            periodic_direction(grid, frame, d, d == 0 ? x_edge : edge);
        } else {
            open_direction(grid, frame, d, d == 0 ? x_edge : edge);
        }
        grid->size[d] = 1 / grid->inverse[d];
        grid->cells *= grid->n[d];
    }
}
