/* SPDX-License-Identifier: BSD-3-Clause */
/* The contact problem of a step as a file, DIR/contact-problem-STEP.hdf5, in the layout of FCLIB's local problems (Acary, Bremond,
 * Koziara and Perignon, FCLIB: a collection of discrete 3D frictional contact problems, INRIA RT-0444, 2014): find u and r with
 *
 *     u = W r + q,  0 <= u_n, r_n;  u_n r_n = 0,  |r_t| <= mu r_n, and r_t against u_t where it slides
 *
 * A contact has three rows: normal and two tangents. Beside FCLIB's objects the file has /solution/r and /solution/u, which the run
 * has found, and the group /scree of what W and q do not tell apart. */
#ifndef SCREE_FORMATS_CONTACT_PROBLEM_H
#define SCREE_FORMATS_CONTACT_PROBLEM_H

#include "base/error.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Plain data; arrays of 3 x contacts but for those of the matrix, `mu` and `id`. Borrowed. */
struct contact_problem {
    size_t contacts;
    const int32_t *start; /* columns of W, which is symmetric: 3 x contacts + 1 */
    const int32_t *row;   /* start[3 x contacts], as `value` */
    const double *value;
    const double *q, *mu;
    const double *r, *u;   /* the solution of the run */
    const double *soft;    /* the part of W's diagonal that is compliance, velocity over impulse */
    const double *shift;   /* the part of q that is no velocity: gaps over the step, and tangential springs */
    const int64_t *id;     /* contacts x 2: ids of the particles; of a wall -(number + 1) */
    double dt, gravity;    /* the step; its size of the acceleration */
    const char *described; /* text */
};

/* Writes the file; it appears whole or not at all. One rank. */
bool contact_problem_write(const char *directory, uint64_t step, const struct contact_problem *problem,
                           struct error *error);

/* Removes the files of later steps than `step`; -1: all. One rank. */
void contact_problem_discard(const char *directory, int64_t step);

#endif
