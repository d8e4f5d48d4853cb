/* SPDX-License-Identifier: BSD-3-Clause */
/* The inside of a closed mesh, as a region to pack spheres in.
 *
 * A sphere never leaves: a move is shorter than its room, its centre is pushed away from the nearest triangle until none is nearer than
 * its room, and if that fails, or ends farther than its room from the place before, the sphere stays where it was. All places
 * within its room of that place are inside, since no wall is. */
#ifndef SCREE_PACK_HULL_H
#define SCREE_PACK_HULL_H

#include "base/error.h"
#include "data/scene/region.h"

struct wall_mesh;
struct wall_grid;

struct hull {
    struct wall_mesh *mesh;
    struct wall_grid *grid;
    struct region_surface
        surface; /* in the coordinates of the file, times its scale; its context is the hull */
};

/* Reads a mesh of any format that walls know. Fails (user) if it encloses no volume. NULL: error filled. Destroy frees and nulls. One
 * thread. */
struct hull *hull_create(const char *file, double scale, struct error *error);
void hull_destroy(struct hull **hull);

#endif
