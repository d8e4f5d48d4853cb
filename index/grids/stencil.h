/* SPDX-License-Identifier: BSD-3-Clause */
/* Stencils: the pencils around a cell that can hold a partner, each with its number of cells to either side
 * in x. Offsets are sorted by (dz, dy); cells that are farther away than the reach are left out. */
#ifndef SCREE_INDEX_GRIDS_STENCIL_H
#define SCREE_INDEX_GRIDS_STENCIL_H

#include "index/grids/grid.h"

struct stencil_run {
    int dy, dz; /* cells */
    int dx;     /* cells to either side */
};

struct stencil {
    struct stencil_run *run;
    size_t count, capacity;
    size_t middle; /* the own pencil's run */
    int extent[3]; /* cells to either side */
};

/* Fills the stencil of a grid for a reach (frame units): every cell that comes nearer than `reach` to some
 * point of the own cell, for any rounding of cells. Offsets that no cell of the grid has are left out, but
 * for images of periodic directions. False, and an empty stencil, if it would have more than `most` runs. */
bool stencil_make(struct stencil *stencil, const struct grid *grid, const struct frame *frame, float reach,
                  size_t most);
void stencil_free(struct stencil *stencil);

#endif
