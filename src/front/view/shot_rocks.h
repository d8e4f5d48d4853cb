/* SPDX-License-Identifier: BSD-3-Clause */
/* What a page is shown of rocks (physics/bodies/rock.h): the polygons of their shapes, and the shape and orientation of each. */
#ifndef SCREE_VIEW_SHOT_ROCKS_H
#define SCREE_VIEW_SHOT_ROCKS_H

#include "engine/state.h"
#include <stdio.h>

/* Floats of a rock behind those of a particle. */
enum { SHOT_ROCK_NUMBERS = 5 };

/* True if the run has rocks. */
bool shot_rocks_there(const struct simulation *simulation);

/* Writes the shapes as JSON, in the order of their numbers, with the ball around each as unit: [{"corners": [x, y, z, ...], "polygons":
 * [[0, 1, 2], ...]}, ...]; null stands for a shape of spheres. */
void shot_rocks_write(FILE *file, const struct simulation *simulation);

/* The number of the shape + 1, 0 of a sphere, and the quaternion x y z w from the frame of the shape to space, of owned particle i. */
void shot_rocks_take(const struct simulation *simulation, size_t i, float row[SHOT_ROCK_NUMBERS]);

#endif
