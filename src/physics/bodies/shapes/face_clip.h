/* SPDX-License-Identifier: BSD-3-Clause */
/* The part that two faces have in common, seen along a normal: Sutherland and Hodgman, Commun. ACM 17 (1974) 32, with
 * corners that know of which features they are. */
#ifndef SCREE_SHAPES_FACE_CLIP_H
#define SCREE_SHAPES_FACE_CLIP_H

#include "physics/bodies/shapes/posed.h"
#include <stdint.h>

enum { FACE_CLIP_MAX = 2 * SOLID_CORNERS_MAX };

struct face_clip_corner {
    double at[2]; /* along both axes, about the centre of A */
    uint32_t key; /* touch_key */
    int edge;     /* the edge behind it: of A its number, of B ~number */
};

struct face_clip {
    double axis[2][3]; /* at right angles to the normal */
    double plane[2]
                [3]; /* of each face: height along the normal = plane[0] at[0] + plane[1] at[1] + plane[2] */
    int count;
    struct face_clip_corner corner[FACE_CLIP_MAX];
};

/* Makes the common part of a face of A with one of B; both are turned to each other by less than a right angle. */
void face_clip_make(struct face_clip *clip, const struct posed *a, int face_a, const struct posed *b,
                    int face_b, const double apart[3], const double normal[3]);

/* Heights of both faces at corner k. */
void face_clip_heights(const struct face_clip *clip, int k, double *of_a, double *of_b);

#endif
