/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles to frame coordinates, and these to cells, a batch at a time: plain loops over small arrays, which
 * compilers turn into vector instructions. The results are those of grid_frame_coordinate and grid_cell to the
 * last bit. */
#ifndef SCREE_INDEX_GRIDS_LOCATE_H
#define SCREE_INDEX_GRIDS_LOCATE_H

#include "index/grids/grid.h"

enum { LOCATE_BATCH = 128 };

struct located {
    size_t count;
    float x[3][LOCATE_BATCH]; /* frame coordinates */
    double r[LOCATE_BATCH];   /* radii, length unit */
    uint32_t cell[3][LOCATE_BATCH];
    bool clamped; /* the frame clamped some coordinate */
};

/* Coordinates and radii of `count` <= LOCATE_BATCH particles: those listed, or (NULL) first, first + 1 ... */
void locate_particles(struct located *located, const struct index_view *view, const struct frame *frame,
                      const uint32_t *list, size_t first);

/* The cells of the located particles. */
void locate_cells(struct located *located, const struct grid *grid);

#endif
