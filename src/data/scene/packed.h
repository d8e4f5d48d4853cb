/* SPDX-License-Identifier: BSD-3-Clause */
/* Dense packings: spheres at random places that move until none overlap. Each rank makes all of them, with its threads; the spheres are the
 * same bits for any number of ranks and threads. */
#ifndef SCREE_SCENE_PACKED_H
#define SCREE_SCENE_PACKED_H

#include "data/scene/scene_share.h"
#include "data/scene/source_batch.h"

/* How the packing of a scene went. */
struct packed_report {
    int sweeps;     /* in all */
    double overlap; /* the largest that is left, as part of the smaller radius; 0: none */
    /* Sources that give way: */
    uint64_t started; /* spheres before any was taken out */
    uint64_t removed; /* for overlaps with other sources */
    uint64_t thinned; /* at random, as more than counted were left */
};

/* Makes the spheres of all packed sources; `batch` has those of all others but random ones, which stay. Sources that push are packed together;
 * then each source that gives way is packed by itself, and its spheres that overlap others are taken out. Fills batch[S] for each packed source S; the caller
 * frees the batches, also after a failure. Radii and places depend on the seed and the packed sources alone. Fails (user) if the spheres do not fit.
 * Opens its own thread teams. */
bool packed_make(const struct scene *scene, const struct scene_share *share, struct source_batch *batch,
                 struct error *error);

#endif
