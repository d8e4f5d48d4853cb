/* SPDX-License-Identifier: BSD-3-Clause */
/* The shapes of a scene: one of each clump, one of each variant of a rock. */
#ifndef SCREE_BODIES_BODIES_SHAPES_H
#define SCREE_BODIES_BODIES_SHAPES_H

#include "physics/bodies/bodies.h"
#include "data/formats/output_shapes.h"

/* Makes all shapes, with their entries; borrows the options. Reads the files of entries. False, with a user's error, where one cannot be
 * made. bodies_shapes_free releases, in any case. */
bool bodies_shapes_make(struct bodies *bodies, const struct scene *scene,
                        const struct bodies_options *options, struct error *error);
void bodies_shapes_free(struct bodies *bodies);

/* Key `key` of entry k, those of clumps first, as messages name it ("bodies.shapes[0].size"); "": the entry. Returns `text`. */
const char *bodies_shapes_key(const struct bodies_options *options, int k, const char *key, char *text,
                              size_t room);

/* Adds the polygons of rocks to the shapes for files. */
void bodies_shapes_show(const struct bodies *bodies, struct output_shapes *shapes);

/* The number of shapes. */
int bodies_shapes_count(const struct bodies_options *options);

/* Radius of the sphere that has the volume of a shape in the size of its entry. */
double bodies_shapes_radius(const struct clump *clump);

#endif
