/* SPDX-License-Identifier: BSD-3-Clause */
/* Chooses the grid of bricks that divides the box among ranks, for domain.c and for callers that know the
 * positions of the particles. */
#ifndef SCREE_COMM_DOMAIN_GRID_H
#define SCREE_COMM_DOMAIN_GRID_H

#include "base/error.h"
#include "kernel/particles/box.h"

/* A coarse map of the particles: each edge of the box is divided into so many equal parts, and an entry of
 * the map is the number of particles in a part. The part (i, j, k) is entry i + BINS (j + BINS k). */
enum { DOMAIN_DENSITY_BINS = 32 };

/* The best way to write `size` as a product of three. First, the largest number of particles in a brick must
 * be within about a tenth of the least over all grids. Of these grids, the function chooses the one that cuts
 * the box along the smallest area; among equal areas the one with the thickest bricks. Without a density
 * (NULL) the area decides alone. `wanted`: ranks per direction, 0: free. A 2D box is never divided in z.
 * False if no grid is possible. Time: number of products x size of the map. Any rank. */
bool domain_grid_choose(int size, const struct box *box, const int wanted[3], const double *density,
                        int best[3]);

/* Sets the error that says why no grid is possible. */
bool domain_grid_refuse(int size, const struct box *box, const int wanted[3], struct error *error);

#endif
