/* SPDX-License-Identifier: BSD-3-Clause */
/* How many threads a program's teams have. */
#ifndef SCREE_CORE_THREADS_H
#define SCREE_CORE_THREADS_H

#include "core/error.h"

/* Sets the size of all teams from here on and returns it: `wanted`, or with 0 as many as OMP_NUM_THREADS or
 * the cores say, at most `most`. It is the size that a team opened for trial got, as blocks of work are dealt
 * out to so many threads beforehand; nothing may change it later (OMP_DYNAMIC is switched off). 0, and an
 * error, if more are wanted than `most` or than the system grants (OMP_THREAD_LIMIT). One thread. */
int threads_set(int wanted, int most, struct error *error);

#endif
