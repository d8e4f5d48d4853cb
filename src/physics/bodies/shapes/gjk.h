/* SPDX-License-Identifier: BSD-3-Clause */
/* The distance of two convex sets of corners, and how deep they overlap.
 *
 * gjk_distance is the algorithm of Gilbert, Johnson and Keerthi (IEEE J. Robot. Autom. 4 (1988) 193): the point of the difference
 * B - A nearest to the origin, by a simplex of up to four of its corners that walks towards it. The places of the
 * simplices follow Ericson, Real-Time Collision Detection (2005), section 5.1. A simplex of the step before is a good
 * start: bodies that turn little need one or two rounds. */
#ifndef SCREE_SHAPES_GJK_H
#define SCREE_SHAPES_GJK_H

#include <stdbool.h>
#include <stdint.h>

/* Corners about an origin of the set's own; borrowed. */
struct gjk_set {
    int corners;
    const double (*corner)[3];
};

/* The corners of both sets that span the nearest points; count 0: unknown. */
struct gjk_simplex {
    int count;
    uint8_t a[4], b[4];
};

struct gjk_nearest {
    double distance, normal[3]; /* unit vector from A to B */
    double on_a[3], on_b[3];    /* the nearest points, about the origin of A */
    int rounds;
};

/* The distance of A from B, whose origin lies at `apart` from that of A. `simplex` is the start, and becomes the result.
 * False: the sets overlap, or are nearer than a millionth of their size. Any thread. */
bool gjk_distance(const struct gjk_set *a, const struct gjk_set *b, const double apart[3],
                  struct gjk_simplex *simplex, struct gjk_nearest *nearest);

#endif
