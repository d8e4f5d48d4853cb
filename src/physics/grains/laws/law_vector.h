/* SPDX-License-Identifier: BSD-3-Clause */
/* Vectors of the contact laws and of walls. */
#ifndef SCREE_LAWS_LAW_VECTOR_H
#define SCREE_LAWS_LAW_VECTOR_H

#include "physics/grains/laws/law_form.h"
#include <float.h>

struct law_vector {
    double x, y, z;
};

LAW_INLINE double law_dot(struct law_vector a, struct law_vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* a + s b */
LAW_INLINE struct law_vector law_add(struct law_vector a, double s, struct law_vector b) {
    return (struct law_vector){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

LAW_INLINE struct law_vector law_scale(double s, struct law_vector a) {
    return (struct law_vector){s * a.x, s * a.y, s * a.z};
}

LAW_INLINE struct law_vector law_cross(struct law_vector a, struct law_vector b) {
    return (struct law_vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

LAW_INLINE double law_max(double a, double b) {
    return a > b ? a : b;
}

/* The part of `a` in the plane with unit normal n. */
LAW_INLINE struct law_vector law_project(struct law_vector a, struct law_vector n) {
    return law_add(a, -law_dot(a, n), n);
}

/* Turns `a` into the plane with unit normal n: projected, and with `rescale` brought back to its length
 * (Luding 2008). */
LAW_INLINE struct law_vector law_turn(struct law_vector a, struct law_vector n, double rescale) {
    struct law_vector p = law_project(a, n);
    double factor = sqrt(law_dot(a, a) / law_max(law_dot(p, p), DBL_MIN));
    return law_scale(rescale > 0.0 ? factor : 1.0, p);
}

/* Turns `a`, which lies in the plane with unit normal m, into that with n: the smallest rotation that takes m
 * to n. */
LAW_INLINE struct law_vector law_transport(struct law_vector a, struct law_vector m, struct law_vector n) {
    double share = law_dot(a, n) / law_max(1.0 + law_dot(m, n), DBL_EPSILON);
    return law_add(a, -share, law_add(m, 1.0, n));
}

#endif
