/* SPDX-License-Identifier: BSD-3-Clause */
/* The contact of two rounded solids: one normal, and up to eight points.
 *
 * The normal is that of the nearest points of the cores (gjk.h); where the cores overlap, that of the least translation which
 * parts them (deep.h). The overlap is the sum of both roundings less the distance of the cores. So a contact of corners and edges is that
 * of two spheres of the radii of the roundings, whose middles are the nearest points, and its force is that of a potential.
 *
 * Where two faces are opposite, more than one point overlaps. The faces are projected along the normal, and the corners of the
 * part that they have in common are points of the contact, if they overlap: corners of either face, and crossings of two
 * edges. The overlap of a point is measured along the normal. A point takes the share overlap / sum of the overlaps of the force
 * that the law gives for its overlap: a contact of faces is not stiffer than one of corners, and a point comes and goes
 * with no force, so that nothing jumps when two faces tilt.
 *
 * A sphere is a solid with one corner, whose rounding is its radius; a triangle has three corners. */
#ifndef SCREE_SHAPES_TOUCH_H
#define SCREE_SHAPES_TOUCH_H

#include "physics/bodies/shapes/gjk.h"
#include "physics/bodies/shapes/posed.h"
#include "physics/bodies/shapes/touch_key.h"

enum { TOUCH_POINTS_MAX = 8 };

struct touch_point {
    double at[3];   /* in the middle of the overlap, about the centre of A */
    double overlap; /* > 0 */
    double share;   /* of the contact; together 1 */
    uint32_t key;   /* touch_key */
};

struct touch {
    double normal[3]; /* unit vector from A to B */
    double overlap;   /* of the nearest points */
    int points;
    struct touch_point point[TOUCH_POINTS_MAX];
};

/* Finds the contact of A with B, whose centre lies at `apart` from that of A. `simplex`: see gjk.h. False: they do not
 * touch. Any thread. */
bool touch_find(const struct posed *a, const struct posed *b, const double apart[3],
                struct gjk_simplex *simplex, struct touch *touch);

#endif
