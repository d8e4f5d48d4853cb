/* SPDX-License-Identifier: BSD-3-Clause */
/* A body as Newton's method sees it: the root S of its inverse mass and inertia, with S St the inverse, and what a contact
 * does to it. Of spheres S is diagonal; of rigid bodies its lower right block is the lower factor of Cholesky of the inverse
 * inertia in space. Geometry and mechanics alone: no lists, no threads, no ranks. */
#ifndef SCREE_HARD_NEWTON_BODY_H
#define SCREE_HARD_NEWTON_BODY_H

#include "physics/hard/row.h"

/* The root of a body's inverse inertia over its `swing`: xx yx yy zx zy zz of a lower triangle. */
enum { HARD_ROOT = 6 };

/* The root of one sphere. */
static const double hard_root_sphere[HARD_ROOT] = {1.0, 0.0, 1.0, 0.0, 0.0, 1.0};

/* The root of an inverse inertia (arm.h); of two dimensions, where it turns about z alone, the rest is 0. */
static inline void hard_root_make(const double turn[HARD_TENSOR], double root[HARD_ROOT]) {
    root[0] = sqrt(fmax(turn[0], 0.0));
    root[1] = root[0] > 0.0 ? turn[3] / root[0] : 0.0;
    root[3] = root[0] > 0.0 ? turn[4] / root[0] : 0.0;
    root[2] = sqrt(fmax(turn[1] - root[1] * root[1], 0.0));
    root[4] = root[2] > 0.0 ? (turn[5] - root[3] * root[1]) / root[2] : 0.0;
    root[5] = sqrt(fmax(turn[2] - root[3] * root[3] - root[4] * root[4], 0.0));
}

/* That of body k; root NULL: all bodies are spheres. */
static inline const double *hard_root_at(const double (*root)[HARD_ROOT], size_t k) {
    return root ? root[k] : hard_root_sphere;
}

/* S x: velocity and spin. */
static inline void hard_root_times(const struct hard_body *body, const double root[HARD_ROOT],
                                   const double x[6], double out[6]) {
    double light = sqrt(body->lightness), swing = sqrt(body->swing);
    for (int d = 0; d < 3; d++)
        out[d] = light * x[d];
    out[3] = swing * (root[0] * x[3]);
    out[4] = swing * (root[1] * x[3] + root[2] * x[4]);
    out[5] = swing * (root[3] * x[3] + root[4] * x[4] + root[5] * x[5]);
}

/* St x, of an impulse and its moment. */
static inline void hard_root_back(const struct hard_body *body, const double root[HARD_ROOT],
                                  const double x[6], double out[6]) {
    double light = sqrt(body->lightness), swing = sqrt(body->swing);
    for (int d = 0; d < 3; d++)
        out[d] = light * x[d];
    out[3] = swing * (root[0] * x[3] + root[1] * x[4] + root[3] * x[5]);
    out[4] = swing * (root[2] * x[4] + root[4] * x[5]);
    out[5] = swing * (root[5] * x[5]);
}

/* From the centre of end e to the point of contact. */
static inline void hard_lever(const struct hard_row *row, int e, double lever[3]) {
    for (int d = 0; d < 3; d++)
        lever[d] = row->arm ? row->arm->lever[e][d] : (e ? -row->lever[1] : row->lever[0]) * row->normal[d];
}

/* Adds an impulse at a contact, and its moments, to the sums of its bodies. */
static inline void hard_scatter(double (*sum)[6], const struct hard_row *row, const double impulse[3]) {
    double turn[2][3], *a = sum[row->body[0]], *b = sum[row->body[1]];
    if (row->arm) {
        vector_cross(row->arm->lever[0], impulse, turn[0]);
        vector_cross(impulse, row->arm->lever[1], turn[1]);
    } else {
        vector_cross(row->normal, impulse, turn[1]);
        for (int d = 0; d < 3; d++) {
            turn[0][d] = row->lever[0] * turn[1][d];
            turn[1][d] *= row->lever[1];
        }
    }
    for (int d = 0; d < 3; d++) {
        a[d] -= impulse[d];
        b[d] += impulse[d];
        a[3 + d] -= turn[0][d];
        b[3 + d] -= turn[1][d];
    }
}

/* The velocity at a contact by velocities and spins. */
static inline void hard_gather(const double (*way)[6], const struct hard_row *row, double u[3]) {
    const double *a = way[row->body[0]], *b = way[row->body[1]];
    double turn[3], rolled[3];
    if (row->arm) {
        vector_cross(a + 3, row->arm->lever[0], rolled);
        vector_cross(b + 3, row->arm->lever[1], turn);
        for (int d = 0; d < 3; d++)
            rolled[d] -= turn[d];
    } else {
        for (int d = 0; d < 3; d++)
            turn[d] = row->lever[0] * a[3 + d] + row->lever[1] * b[3 + d];
        vector_cross(turn, row->normal, rolled);
    }
    for (int d = 0; d < 3; d++)
        u[d] = b[d] - a[d] - rolled[d];
}

#endif
