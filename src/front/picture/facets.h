/* SPDX-License-Identifier: BSD-3-Clause */
/* The rocks of a frame (physics/bodies/rock.h), as what POV-Ray draws of them: faces, and edges and corners with their rounding. */
#ifndef SCREE_PICTURE_FACETS_H
#define SCREE_PICTURE_FACETS_H

#include "front/picture/camera.h"
#include "front/picture/picture_source.h"
#include "physics/bodies/bodies.h"
#include <stdio.h>

struct facets {
    int shapes;
    struct clump *shape;
    size_t rows;
    int *number;       /* of the shape of each row; -1: a sphere */
    double (*turn)[9]; /* rotation from the frame of the shape to space */
};

/* Finds the rocks among the rows of a frame. None where the scene has none; and, with a user's error, where the file does not tell their
 * orientations. facets_free releases. */
bool facets_make(struct facets *facets, const struct source *source, int64_t frame, const struct rows *rows,
                 struct error *error);
void facets_free(struct facets *facets);

/* True of the rows that are bodies: their members are drawn, and not they. memory_free releases. */
bool *facets_bodies(const struct source *source, int64_t frame, const struct rows *rows);

/* Declares the shapes: R0, R1, ... */
void facets_declare(FILE *out, const struct facets *facets);

/* Writes row k, without its texture; false: it is a sphere. */
bool facets_write(FILE *out, const struct facets *facets, const struct camera *camera,
                  const struct rows *rows, size_t k);

#endif
