/* SPDX-License-Identifier: BSD-3-Clause */
/* Numbers and radii of packed sources. */
#ifndef SCREE_SCENE_PACKED_RADII_H
#define SCREE_SCENE_PACKED_RADII_H

#include "data/scene/pack/pile.h"
#include "data/scene/source_batch.h"
#include "data/scene/source_radii.h"

/* The largest over the smallest radius of spheres that are packed together. */
enum { PACKED_RATIO_MAX = 1000 };

/* One source at work. */
struct member {
    struct pile_part part;
    int64_t first; /* number of its first sphere */
    struct source_radii radii;
    double volume; /* of the region */
};

struct packing {
    const struct scene *scene;
    const struct scene_share *share;
    struct source_batch *batch;
    struct error *error;
    struct box box; /* that of the scene, before it moves */
    struct member *member;
    struct packed_report *report;
    double overlap; /* the largest that is left so far */
};

/* True if the source is a packed one. */
bool packed_is(const struct packing *p, int source);

/* Fills the error with the place of a key of the source and the text; returns false. */
bool packed_fail(const struct packing *p, int source, const char *key, const char *text);

/* False, with an error, if there are too many spheres to be numbered. */
bool packed_can_number(const struct packing *p);

/* Draws the radii of a source, numbers its spheres from *next on, and moves *next behind them. Fails (user) if the spheres have no
 * room. */
bool packed_radii(struct packing *p, int source, int64_t *next);

/* The edge of the cube (square) that has the volume fraction of a packed source with its count of spheres; 0: error filled. One thread. */
double packed_edge(const struct scene *scene, int source, struct error *error);

#endif
