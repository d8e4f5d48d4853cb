/* SPDX-License-Identifier: BSD-3-Clause */
/* What the points of a contact of two solids remember from step to step. */
#ifndef SCREE_SHAPES_RECALL_H
#define SCREE_SHAPES_RECALL_H

#include "physics/bodies/shapes/feature.h"

/* What a point remembers. Numbers of a restart, doubles alone. */
struct touch_memory {
    double key;                /* touch_key */
    double place[3];           /* in the frame of the first solid */
    double spring[3], roll[3]; /* of the second one; rocks: of the end with the higher id, or of the wall */
};
enum { TOUCH_NUMBERS = sizeof(struct touch_memory) / sizeof(double) };

/* Fills `now` for the points of a contact. Each one has the springs that the same point had among the `count` before: by its features,
 * else by the nearest place of one that no other point has, if it is nearer than `reach`. A new point has none. `turn`: of the first
 * solid. Any thread. */
void recall_points(const struct touch_memory *before, int count, const double turn[9],
                   const struct touch *touch, double reach, struct touch_memory *now);

#endif
