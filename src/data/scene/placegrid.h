/* SPDX-License-Identifier: BSD-3-Clause */
/* Spheres that were placed, to be asked whether a new one would touch any of them. Hashed cells on levels of
 * doubling size, so that neither the size ratio nor the extent of the box matters; periodic directions wrap.
 * Box-relative coordinates. */
#ifndef SCREE_SCENE_PLACEGRID_H
#define SCREE_SCENE_PLACEGRID_H

#include "kernel/particles/box.h"

struct placegrid;

/* An empty grid. `radius_min` is the unit of the levels: smaller spheres are allowed but share a level. */
struct placegrid *placegrid_create(const struct box *box, double radius_min);
void placegrid_destroy(struct placegrid **grid);

/* Adds a sphere; x is wrapped in periodic directions. */
void placegrid_add(struct placegrid *grid, const double x[3], double radius);

/* True if a sphere here would overlap one of the grid (touching is allowed). */
bool placegrid_touches(const struct placegrid *grid, const double x[3], double radius);

#endif
