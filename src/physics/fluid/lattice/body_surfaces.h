/* SPDX-License-Identifier: BSD-3-Clause */
/* Bodies: what bounds the fluid. A body is a grain, by its id, or a wall, by -1 - its number, or an open side of the
 * box, by -1 - WALLS_MAX - its number (2 x direction, 1 more for the upper side). Geometry alone:
 * the point of a body's surface nearest to x, the normal there out of the body, the signed distance and the
 * velocity of the surface. */
#ifndef SCREE_LATTICE_BODY_SURFACES_H
#define SCREE_LATTICE_BODY_SURFACES_H

#include "physics/fluid/operators/weights.h"
#include "physics/grains/walls/wall.h"

/* The body of a boundary particle that stands alone, in a closed pocket of fluid: its own place is the wall. */
enum { BODY_NONE = 0 };

/* The number of a wall as a body, and back. */
static inline int64_t body_of_wall(int wall) {
    return -1 - wall;
}
static inline int body_wall(int64_t body) {
    return (int)(-1 - body);
}

/* The number of an open side as a body, and back; -1 if the body is none. */
static inline int64_t body_of_side(int side) {
    return -1 - WALLS_MAX - side;
}
static inline int body_side(int64_t body) {
    return body < -WALLS_MAX ? (int)(-1 - WALLS_MAX - body) : -1;
}

/* The foot of x on a sphere: `away` = x - centre, `velocity` and `omega` (NULL: no spin) of the sphere, whose
 * rigid motion at x is the velocity of the foot. The distance is negative inside. A point at the centre has a normal along x. Any thread. */
void body_sphere_foot(const double away[3], double radius, int dimension, const double velocity[3],
                      const double *omega, struct weights_foot *foot);

/* Distance of x_j behind the tangent plane of a foot, 0 in front of it; `apart` = x_j - x_i. */
static inline double body_behind(const struct weights_foot *foot, const double apart[3]) {
    double along = foot->distance;
    for (int d = 0; d < 3; d++)
        along += foot->normal[d] * apart[d];
    return along < 0 ? -along : 0;
}

#endif
