/* SPDX-License-Identifier: BSD-3-Clause */
/* Counts the ranks of this machine and shares out its cores. Read cores.h first. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* sched_getaffinity */
#endif
#include "kernel/comm/cores.h"

#include <omp.h>
#include <sched.h>
#include <stdlib.h>

int cores_each(const struct comm *comm) {
    cpu_set_t mine, all;
    MPI_Comm machine;
    int ranks;
    if (sched_getaffinity(0, sizeof mine, &mine) != 0) /* fails with too many cores for a set */
        CPU_ZERO(&mine);
    comm_check(MPI_Comm_split_type(comm->handle, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine),
               "MPI_Comm_split_type");
    comm_check(MPI_Comm_size(machine, &ranks), "MPI_Comm_size");
    comm_check(MPI_Allreduce(&mine, &all, (int)sizeof mine, MPI_BYTE, MPI_BOR, machine), "MPI_Allreduce");
    comm_check(MPI_Comm_free(&machine), "MPI_Comm_free");
    int share = CPU_COUNT(&all) / ranks, most = CPU_COUNT(&mine);
    share = share < most ? share : most;
    return share > 1 ? share : 1;
}

int cores_threads(const struct comm *comm) {
    int share = cores_each(comm);
    return getenv("OMP_NUM_THREADS") ? omp_get_max_threads() : share;
}
