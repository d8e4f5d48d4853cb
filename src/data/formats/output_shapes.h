/* SPDX-License-Identifier: BSD-3-Clause */
/* The shapes of bodies with flat faces, for files: orientations in the fields of a frame are of these. */
#ifndef SCREE_FORMATS_OUTPUT_SHAPES_H
#define SCREE_FORMATS_OUTPUT_SHAPES_H

#include "data/formats/output_options.h"
#include "base/error.h"
#include <stdint.h>

/* One shape, by polygons in its own frame. Owned arrays. */
struct output_shape {
    int number; /* in the field that names it */
    char name[OUTPUT_NAME_MAX];
    double
        radius; /* of the ball around it about the origin: the radius of a particle over this is its scale */
    double rounding; /* of edges and corners */
    int corners, polygons;
    double (*corner)[3];
    int *start; /* polygon p: ring[start[p]] ... [start[p + 1]) */
    int *ring;
};

struct output_shapes {
    int count;
    struct output_shape *shape;
};

/* Adds a zeroed shape. */
struct output_shape *output_shapes_add(struct output_shapes *shapes);
void output_shapes_free(struct output_shapes *shapes);

/* Bytes that they need in a file, at most. */
uint64_t output_shapes_bytes(const struct output_shapes *shapes);

struct h5md;
struct h5;

/* Writes /parameters/shapes/NUMBER: corners, and the polygons between them. Collective. */
bool output_shapes_write(const struct h5md *h5md, const struct h5 *h5, struct error *error);

/* Reads the shapes of a trajectory; none, where it has none. One rank. False, with an error, where they are damaged.
 * output_shapes_free releases. */
bool output_shapes_read(const char *path, struct output_shapes *shapes, struct error *error);

#endif
