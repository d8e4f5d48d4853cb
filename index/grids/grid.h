/* SPDX-License-Identifier: BSD-3-Clause */
/* The geometry of one grid: how frame coordinates map to cells.
 *
 * The same float operations give the cell of a particle and the cells of the ends of a search window, and
 * these operations are monotone: every particle within a window lies in the window's cells, for any rounding.
 * Particles beyond the grid belong to its outermost cells. In open directions cells are numbered from the
 * owned particles' lower end, so that ghosts add whole cells at both ends and do not change the order of the
 * other particles. */
#ifndef SCREE_INDEX_GRIDS_GRID_H
#define SCREE_INDEX_GRIDS_GRID_H

#include "index/grids/grid_frame.h"

struct grid {
    float anchor[3], inverse[3]; /* frame unit, cells a frame unit */
    float size[3];               /* cell edges, frame unit */
    float base[3], top[3];       /* first and last cell, counted from the anchor (whole numbers) */
    int n[3];                    /* cells a direction, at most 2^20 + 1 */
    double cells;                /* product of n */
    double edge;                 /* wanted cell edge, length unit */
};

/* Lays a grid of cells over the frame: edge in y and z, x_edge in x, length unit, both > 0 and made larger
 * where needed (in periodic directions to divide the box; nowhere more than 2^20 cells). */
void grid_make(struct grid *grid, const struct frame *frame, double edge, double x_edge);

/* The cell of a frame coordinate in direction d, 0 ... n[d] - 1. */
static inline int grid_cell(const struct grid *grid, int d, float x) {
    float t = (x - grid->anchor[d]) * grid->inverse[d];
    t = t > grid->base[d] ? t : grid->base[d];
    t = t < grid->top[d] ? t : grid->top[d];
    int c = (int)t;
    c -= (float)c > t;
    return c - (int)grid->base[d];
}

#endif
