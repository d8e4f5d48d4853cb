/* SPDX-License-Identifier: BSD-3-Clause */
/* Spheres at random places. */
#ifndef SCREE_SCENE_SCATTER_H
#define SCREE_SCENE_SCATTER_H

#include "data/scene/placegrid.h"
#include "data/scene/scene_share.h"
#include "data/scene/source_batch.h"

/* Places the spheres of all random sources, the largest of all first, without touching each other, spheres in
 * `grid` (which receives the new ones) or taken places (share->taken). Fills batch[S] for each random source S;
 * the caller frees the batches, also after a failure. Each sphere's places depend on seed, source and its
 * number alone. */
bool scatter_make(const struct scene *scene, const struct scene_share *share, struct placegrid *grid,
                  struct source_batch *batch, struct error *error);

#endif
