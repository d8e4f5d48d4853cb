/* SPDX-License-Identifier: BSD-3-Clause */
/* The number of threads of the program's teams. */
#ifndef SCREE_BASE_THREADS_H
#define SCREE_BASE_THREADS_H

#include "base/error.h"

/* Sets the size of all later teams and returns that size: `wanted`, or if `wanted` is 0 the number from
 * OMP_NUM_THREADS or from the cores, at most `most`. The size is the one that a team opened for trial got, as
 * blocks of work are dealt out to so many threads beforehand. Nothing may change the size later (OMP_DYNAMIC
 * is switched off). Returns 0, with an error, if `wanted` exceeds `most` or the system's limit
 * (OMP_THREAD_LIMIT). One thread. */
int threads_set(int wanted, int most, struct error *error);

#endif
