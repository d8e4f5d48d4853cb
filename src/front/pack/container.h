/* SPDX-License-Identifier: BSD-3-Clause */
/* The space that a packing fills: a cube, a box, an upright cylinder, a sphere, or the inside of a mesh. Positions are relative to the
 * lower corner of the box around the container.
 *
 * A sphere with `room` around its centre lies inside if the centre is at least `room` away from every wall. Clamping a coordinate, or a
 * distance from an axis or a centre, brings a sphere back into the simple shapes. Inside a mesh a sphere never leaves: a move is shorter than
 * its room, its centre is pushed away from the nearest triangle until none is nearer than its room, and if that fails, or ends farther
 * than its room from the place before, the sphere stays where it was. All places within its room of that place are inside, since no wall
 * is. */
#ifndef SCREE_PACK_CONTAINER_H
#define SCREE_PACK_CONTAINER_H

#include "base/error.h"
#include "base/random.h"
#include "front/pack/options.h"
#include "kernel/particles/particles.h"

struct wall_mesh;
struct wall_grid;

struct pack_container {
    enum pack_shape shape;
    struct box box;         /* around the container; periodic in CUBE and BOX alone */
    double lower[3];        /* of the box, in the user's coordinates */
    double volume;          /* of the container */
    double radius;          /* CYLINDER, SPHERE */
    struct wall_mesh *mesh; /* MESH; coordinates relative to `lower` */
    struct wall_grid *grid; /* MESH */
};

/* Makes the container of the options; a cube whose edge is not given follows from `solid`, the volume of the spheres, and the options'
 * fraction. A cylinder stands on the origin, a sphere has its centre there, a cube or a box has its lower corner there. Fails (user) on
 * a mesh that encloses no volume. container_free releases, after a failure too. One thread. */
bool container_create(struct pack_container *container, const struct pack_options *options, double solid,
                      struct error *error);
void container_free(struct pack_container *container);

/* Fails (user) if a sphere of this room cannot lie in the container or would meet its own image (of a mesh only the box is looked at), or
 * if spheres of the volume `solid` are too much for it. */
bool container_takes(const struct pack_container *container, double room, double solid, struct error *error);

/* Draws a place for a sphere, uniform over all places with this room; false if a mesh showed none in 20,000 draws. Any thread. */
bool container_draw(const struct pack_container *container, double room, struct random_sequence *random,
                    double x[3]);

/* Brings a sphere that moved from a place inside to x back inside; changes x. Any thread. */
void container_hold(const struct pack_container *container, const double from[3], double room, double x[3]);

/* Writes shape and size in words, as in "a cube of edge 20, periodic". */
void container_describe(const struct pack_container *container, const struct pack_options *options,
                        char *text, size_t size);

#endif
