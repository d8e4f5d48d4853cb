/* SPDX-License-Identifier: BSD-3-Clause */
/* The bodies of a contact problem, and the levers of a contact that is not one of spheres alone.
 *
 * Spheres need no more than a length from the centre to the contact: their normal and tangential impulses do not act on
 * each other. A contact of a rigid body has vectors, and the change of the relative velocity by an impulse P is W P with
 *
 *   W = sum over both ends of  lightness 1 - [r] T [r]     T: inverse inertia in space, [r] x = r cross x */
#ifndef SCREE_HARD_ARM_H
#define SCREE_HARD_ARM_H

#include "base/vector.h"
#include <math.h>
#include <stddef.h>

/* A body: velocity and spin, 1/mass and 1/moment of inertia. A wall has zeros for these. Of a rigid body `swing` is a factor
 * of the inverse inertia that its contacts name. */
struct hard_body {
    double v[3], lightness;
    double w[3], swing;
};

/* xx yy zz xy xz yz */
enum { HARD_TENSOR = 6 };

struct hard_local;

/* Finds the impulses of a contact that is alone, normal first; begins with those of the last visit (models.h). */
typedef void hard_relaxation(const struct hard_local *local, double p[3]);

struct hard_arm {
    double lever[2][3]; /* from the centre of mass of each body to the point of contact */
    double branch
        [3]; /* from the first sphere, or ball around a rock, to the second one; of a wall to the point */
    double
        start[3]; /* velocity of the second surface relative to the first without the contacts of the step */
    const double *turn[2]; /* inverse inertia over `swing` of each body; NULL: 1 */
    hard_relaxation *relax;
};

/* The spin that a moment gives a body with this `turn`, over its `swing`. */
static inline void hard_turned(const double *turn, const double moment[3], double out[3]) {
    if (turn == NULL) {
        out[0] = moment[0];
        out[1] = moment[1];
        out[2] = moment[2];
        return;
    }
    out[0] = turn[0] * moment[0] + turn[3] * moment[1] + turn[4] * moment[2];
    out[1] = turn[3] * moment[0] + turn[1] * moment[1] + turn[5] * moment[2];
    out[2] = turn[4] * moment[0] + turn[5] * moment[1] + turn[2] * moment[2];
}

/* The velocity of the second surface relative to the first. */
static inline void hard_arm_velocity(const struct hard_arm *arm, const struct hard_body *a,
                                     const struct hard_body *b, double u[3]) {
    double by_a[3], by_b[3];
    vector_cross(a->w, arm->lever[0], by_a);
    vector_cross(b->w, arm->lever[1], by_b);
    for (int d = 0; d < 3; d++)
        u[d] = (b->v[d] + by_b[d]) - (a->v[d] + by_a[d]);
}

/* Gives the second body an impulse, and the first one the opposite. */
static inline void hard_arm_apply(const struct hard_arm *arm, struct hard_body *a, struct hard_body *b,
                                  const double impulse[3]) {
    double moment[3], spin[2][3];
    for (int e = 0; e < 2; e++) {
        vector_cross(arm->lever[e], impulse, moment);
        hard_turned(arm->turn[e], moment, spin[e]);
    }
    for (int d = 0; d < 3; d++) {
        a->v[d] -= a->lightness * impulse[d];
        b->v[d] += b->lightness * impulse[d];
        a->w[d] -= a->swing * spin[0][d];
        b->w[d] += b->swing * spin[1][d];
    }
}

/* The change of the relative velocity by an impulse: W times it. */
static inline void hard_arm_change(const struct hard_arm *arm, const struct hard_body *a,
                                   const struct hard_body *b, const double impulse[3], double u[3]) {
    struct hard_body still[2] = {{.lightness = a->lightness, .swing = a->swing},
                                 {.lightness = b->lightness, .swing = b->swing}};
    hard_arm_apply(arm, &still[0], &still[1], impulse);
    hard_arm_velocity(arm, &still[0], &still[1], u);
}

#endif
