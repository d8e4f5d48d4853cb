/* SPDX-License-Identifier: BSD-3-Clause */
/* Products and the difference of two vectors of three numbers. Any thread. */
#ifndef SCREE_BASE_VECTOR_H
#define SCREE_BASE_VECTOR_H

static inline double vector_dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void vector_minus(const double a[3], const double b[3], double out[3]) {
    for (int d = 0; d < 3; d++)
        out[d] = a[d] - b[d];
}

/* `out` is neither of the two. */
static inline void vector_cross(const double a[3], const double b[3], double out[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

#endif
