/* SPDX-License-Identifier: BSD-3-Clause */
/* A rounded solid as it stands in space: all places nearer than `rounding` to a core. */
#ifndef SCREE_SHAPES_POSED_H
#define SCREE_SHAPES_POSED_H

#include "physics/bodies/shapes/solid.h"

/* Borrowed arrays. */
struct posed {
    const struct solid *core;  /* in the frame of the body */
    const double (*corner)[3]; /* its corners in space, about the body's centre */
    const double *turn;        /* rotation from the body's frame to space, nine numbers */
    double scale;              /* lengths of the core x this */
    double rounding;           /* length, in space */
};

/* Sets the corners in space. */
static inline void posed_corners(const struct solid *core, const double turn[9], double scale,
                                 double (*corner)[3]) {
    for (int k = 0; k < core->corners; k++)
        for (int d = 0; d < 3; d++) {
            const double *x = core->corner[k];
            corner[k][d] = scale * (turn[3 * d] * x[0] + turn[3 * d + 1] * x[1] + turn[3 * d + 2] * x[2]);
        }
}

/* The normal of a face in space. */
static inline void posed_normal(const struct posed *posed, int face, double normal[3]) {
    const double *n = posed->core->face[face].normal, *turn = posed->turn;
    for (int d = 0; d < 3; d++)
        normal[d] = turn[3 * d] * n[0] + turn[3 * d + 1] * n[1] + turn[3 * d + 2] * n[2];
}

#endif
