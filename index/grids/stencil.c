/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds the offsets of a stencil. Read stencil.h first. */
#include "index/grids/stencil.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

/* The number of cells that the reach extends in direction d: at most all cells (of three boxes in periodic
 * directions). The excess covers cells into which rounding put a particle: a coordinate in cells is accurate
 * to a few n * 2^-24. */
static int extent(const struct grid *grid, const struct frame *frame, int d, double reach) {
    double most = frame->periodic[d] ? 2.0 * grid->n[d] - 1 : grid->n[d] - 1.0;
    double excess = 1e-3 + grid->n[d] * 0x1p-20;
    return (int)fmin(floor(fmax(reach, 0) * grid->inverse[d] + excess) + 1, most);
}

/* The least distance between points of cells that are k apart. */
static double gap(const struct grid *grid, int d, int k) {
    double excess = 1e-3 + grid->n[d] * 0x1p-20;
    return fmax(0, (abs(k) - 1 - excess) * grid->size[d]);
}

bool stencil_make(struct stencil *stencil, const struct grid *grid, const struct frame *frame, float reach,
                  size_t most) {
    int ny = extent(grid, frame, 1, reach), nz = extent(grid, frame, 2, reach);
    stencil->extent[0] = extent(grid, frame, 0, reach);
    stencil->extent[1] = ny;
    stencil->extent[2] = nz;
    size_t room = (2 * (size_t)ny + 1) * (2 * (size_t)nz + 1);
    stencil->count = 0;
    if (room > most) {
        return false;
    }
    if (room > stencil->capacity || stencil->run == NULL) {
        memory_free(stencil->run);
        stencil->run = memory_allocate(room, sizeof *stencil->run, "stencil");
        stencil->capacity = room;
    }
    for (int dz = -nz; dz <= nz; dz++) {
        for (int dy = -ny; dy <= ny; dy++) {
            double rest = (double)reach * reach - gap(grid, 1, dy) * gap(grid, 1, dy) -
                          gap(grid, 2, dz) * gap(grid, 2, dz);
            if (dz == 0 && dy == 0) {
                stencil->middle = stencil->count;
            }
            if (rest >= 0) {
                int dx = extent(grid, frame, 0, sqrt(rest));
                stencil->run[stencil->count++] = (struct stencil_run){dy, dz, dx};
            }
        }
    }
    return true;
}

void stencil_free(struct stencil *stencil) {
    memory_free(stencil->run);
    *stencil = (struct stencil){0};
}
