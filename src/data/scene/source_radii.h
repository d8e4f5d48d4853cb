/* SPDX-License-Identifier: BSD-3-Clause */
/* The radii of a source that makes its spheres from a size law: as many as it counts, or as come nearest to its volume
 * fraction. */
#ifndef SCREE_SCENE_SOURCE_RADII_H
#define SCREE_SCENE_SOURCE_RADII_H

#include "data/scene/scene.h"
#include "data/scene/scene_share.h"

struct source_radii {
    double *radius; /* owned; memory_free */
    size_t count;
    double balls; /* volume of the spheres; in two dimensions area of the discs */
    double solid; /* of it what is solid, where bodies stand in the spheres */
};

/* What is drawn for a source. */
struct source_wish {
    int source;
    uint64_t first; /* item of the first radius in the stream of radii; the next ones follow */
    size_t count;   /* 0: by the volume fraction of the source */
    double volume;  /* of the region; in two dimensions its area */
    double bytes;   /* that the source needs for a sphere, beside SOURCE_BYTES of this rank's part */
};

/* Draws the radii; the radius of a sphere depends on seed and item alone. `radii` is to be freed after a failure, too. Tells share->progress now and then.
 * Fails (user) on more than SOURCE_SPHERES_MAX spheres, none, or too little memory. One thread. */
bool source_radii_draw(const struct scene *scene, const struct scene_share *share,
                       const struct source_wish *wish, struct source_radii *radii, struct error *error);

/* Volume of a sphere, which may be the ball around a body; in two dimensions the area of a disc. */
double source_solid(const struct scene *scene, double radius);

/* Calls share->progress with this part of the work, but not for each sphere. */
void source_tell(const struct scene_share *share, const char *what, size_t done, double all);

#endif
