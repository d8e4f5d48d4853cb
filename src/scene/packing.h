/* SPDX-License-Identifier: BSD-3-Clause */
/* Spheres at random places. */
#ifndef SCREE_SCENE_PACKING_H
#define SCREE_SCENE_PACKING_H

#include "scene/placegrid.h"
#include "scene/scene_share.h"
#include "scene/source_batch.h"

/* Places spheres at random, largest first, without touching each other, spheres in `grid` (which receives
 * the new ones) or taken places (share->taken). Each sphere's place depends on seed, source and its number
 * alone. */
bool packing_make(const struct scene *scene, int source, const struct scene_share *share,
                  struct placegrid *grid, struct source_batch *batch, struct error *error);

#endif
