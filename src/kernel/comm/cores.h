/* SPDX-License-Identifier: BSD-3-Clause */
/* A rank's share of the machine's cores. */
#ifndef SCREE_COMM_CORES_H
#define SCREE_COMM_CORES_H

#include "kernel/comm/comm.h"

/* The number of cores for each rank: the cores that the ranks of this machine may run on, shared out evenly,
 * but no more than this rank itself may run on, and 1 at least. Collective. */
int cores_each(const struct comm *comm);

/* The default number of threads of a rank: OMP_NUM_THREADS, else one thread for each core of the rank.
 * Collective. */
int cores_threads(const struct comm *comm);

#endif
