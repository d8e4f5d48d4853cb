/* SPDX-License-Identifier: BSD-3-Clause */
/* Which share of a machine's cores a rank has. */
#ifndef SCREE_COMM_CORES_H
#define SCREE_COMM_CORES_H

#include "comm/comm.h"

/* How many cores there are for each rank: those that the ranks of this machine may run on, shared out evenly,
 * but no more than this rank itself may run on, and 1 at least. Collective. */
int cores_each(const struct comm *comm);

/* How many threads a rank has where nobody says: those of OMP_NUM_THREADS, else one for each of its cores.
 * Collective. */
int cores_threads(const struct comm *comm);

#endif
