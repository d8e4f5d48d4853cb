/* SPDX-License-Identifier: BSD-3-Clause */
/* The shapes of bodies that a scene has, for what names shapes: sources, files of particles, programs. The section of bodies fills
 * them (bodies_finish); no section: a scene has none. */
#ifndef SCREE_SCENE_SCENE_SHAPES_H
#define SCREE_SCENE_SCENE_SHAPES_H

#include "data/formats/output_shapes.h"
#include "data/scene/source.h"
#include <stdbool.h>
#include <stddef.h>

/* An entry of bodies.clumps or bodies.shapes. */
struct scene_entry {
    char name[SOURCE_NAME_MAX];
    int first, shapes;       /* its shapes; several of random rocks */
    struct source_form form; /* of the grains that name it */
};

/* One shape. */
struct scene_shape {
    int entry;
    double axes
        [4]; /* quaternion that turns its frame, in which files have orientations, to the frame of the entry */
    double solid; /* its volume over that of the ball around it */
    double grain; /* radius of the grain that becomes it over the radius of the ball */
    double drawn; /* radius of the ball where all bodies have the size of the entry; else 0 */
};

struct scene_shapes {
    int entries;
    struct scene_entry *entry; /* those of bodies.clumps first */
    int shapes;                /* 0: not made, as nothing names one */
    struct scene_shape *shape;
    struct output_shapes drawn; /* those of rocks, in their order */
};

void scene_shapes_free(struct scene_shapes **shapes);

/* The number of the entry with a name; -1: none has it, or several, and `why` says so, with the names that are allowed. */
int scene_shapes_find(const struct scene_shapes *shapes, const char *name, char *why, size_t room);

/* True if orientation q may be: not all 0, and in two dimensions about z alone. */
bool scene_shapes_may_turn(const double q[4], int dimension);

#endif
