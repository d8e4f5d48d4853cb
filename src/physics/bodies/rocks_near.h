/* SPDX-License-Identifier: BSD-3-Clause */
/* The points at which two rocks, a rock and a grain, or a rock and a wall may meet within a step: what a solver of contacts asks
 * for, which finds the force of each point by itself.
 *
 * A point is a feature of the contact (physics/bodies/shapes/touch.h) whose gap is below the reach. Features nearer to each other than a hundredth of the smaller
 * rounding, with normals within 20 degrees, are one point, as a corner above a corner: the first one, corners before edges, unless a later one is
 * deeper. Two edges count where the nearest place of one of the solids is on its edge, as elsewhere a face or a
 * corner lies before them; and not where they are nearly parallel, as then the corners at their ends count. */
#ifndef SCREE_BODIES_ROCKS_NEAR_H
#define SCREE_BODIES_ROCKS_NEAR_H

#include "physics/bodies/rocks_ends.h"

enum { ROCKS_POINTS_MAX = 64 };

struct rocks_point {
    double at[3];     /* in the middle of the gap, about the centre of the first end */
    double normal[3]; /* unit vector from the first end to the second */
    double gap;       /* below 0: overlap */
    uint32_t key;     /* of its feature (touch_key) */
};

struct rocks_points {
    int count;
    struct rocks_point point[ROCKS_POINTS_MAX];
    double follow; /* a point may be a neighbour of the step before up to this distance */
};

/* Finds the points of a pair up to the reach of the scene, and its ends; returns their number. Any thread, once a pair, with a
 * probe of the thread's own. */
int rocks_near(const struct rocks_scene *scene, struct rocks_pair *pair, struct walls_probe *probe,
               struct rocks_ends *ends, struct rocks_points *points);

#endif
