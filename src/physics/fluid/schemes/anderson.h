/* SPDX-License-Identifier: BSD-3-Clause */
/* Anderson's method for a fixed point x = x + f(x): from tries x_k with lacks f_k the next one is
 *
 *   x - sum of c_k dx_k + f - sum of c_k df_k,   c the least squares of |f - sum of c_k df_k|
 *
 * over the differences of all tries so far (Anderson, J. ACM 12 (1965) 547; Walker and Ni, SIAM J. Numer. Anal. 49 (2011) 1715; for a linear f it is GMRES). The df_k
 * are made orthogonal one after another, over all ranks. */
#ifndef SCREE_SCHEMES_ANDERSON_H
#define SCREE_SCHEMES_ANDERSON_H

#include "kernel/comm/comm.h"
#include <stddef.h>

enum { ANDERSON_MOST = 12 };

/* All arrays are owned, of `room` numbers each; those of this rank count. All zero: empty. */
struct anderson {
    const struct comm *comm; /* borrowed */
    size_t count, room;
    int tries; /* so far */
    double *x_before, *f_before;
    double *x[ANDERSON_MOST], *f[ANDERSON_MOST]; /* differences, those of f of length 1 and orthogonal */
};

/* Begins a search with `count` numbers on this rank. */
void anderson_begin(struct anderson *anderson, const struct comm *comm, size_t count);

/* x becomes the next try, f its lack. Collective. */
void anderson_next(struct anderson *anderson, double *x, const double *f);

void anderson_free(struct anderson *anderson);

#endif
