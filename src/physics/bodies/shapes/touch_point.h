/* SPDX-License-Identifier: BSD-3-Clause */
/* A contact of two solids as data (touch.h). */
#ifndef SCREE_SHAPES_TOUCH_POINT_H
#define SCREE_SHAPES_TOUCH_POINT_H

#include <stdint.h>

enum { TOUCH_POINTS_MAX = 8 };
#define TOUCH_PARALLEL 0.02
#define TOUCH_MERGE 0.5 /* features that are nearer than this part of the smaller rounding are one point */

/* What a point is, with its numbers: a corner of A, of B, two edges. */
enum touch_kind { TOUCH_DEEP, TOUCH_CORNER_A, TOUCH_CORNER_B, TOUCH_EDGES };

static inline uint32_t touch_key(enum touch_kind kind, int a, int b) {
    return (uint32_t)kind << 16 | (uint32_t)a << 8 | (uint32_t)b;
}

struct touch_point {
    double at[3];     /* in the middle of the overlap, about the centre of A */
    double normal[3]; /* unit vector from A to B */
    double share;     /* of the force that the law gives for the overlap of the contact */
    uint32_t key;     /* touch_key */
};

struct touch {
    double overlap;    /* d */
    double push[3];    /* force on B, over E'(d) */
    double turn[2][3]; /* torques on A and on B about their centres, over E'(d) */
    int points;
    struct touch_point point[TOUCH_POINTS_MAX];
};

#endif
