/* SPDX-License-Identifier: BSD-3-Clause */
/* Which grid of bricks divides the box among ranks, for domain.c and for whoever knows where the particles
 * are. */
#ifndef SCREE_COMM_DOMAIN_GRID_H
#define SCREE_COMM_DOMAIN_GRID_H

#include "core/error.h"
#include "particles/box.h"

/* A coarse map of where particles are: their numbers in so many equal parts along each edge of the box; the
 * part (i, j, k) is entry i + BINS (j + BINS k). */
enum { DOMAIN_DENSITY_BINS = 32 };

/* The best way to write `size` as a product of three: of the grids whose largest number of particles in a
 * brick is within about a tenth of the least that any has, the one that cuts the box along the smallest area;
 * among equal ones that with the thickest bricks. Without a density (NULL) the area decides alone. `wanted`:
 * ranks per direction, 0: free. A 2D box is never divided in z. False if there is none. Time: ways to write
 * it x size of the map. Any rank. */
bool domain_grid_choose(int size, const struct box *box, const int wanted[3], const double *density,
                        int best[3]);

/* Says why there is none. */
bool domain_grid_refuse(int size, const struct box *box, const int wanted[3], struct error *error);

#endif
