/* SPDX-License-Identifier: BSD-3-Clause */
/* The start and end of MPI and the few collective helpers that others need. The only folder that calls MPI is
 * src/kernel/comm.
 *
 * Errors of MPI are returned to the caller, never left to MPI's own handler: every call goes through
 * comm_check, which names the rank, the call and MPI's text, and ends the program on all ranks. */
#ifndef SCREE_COMM_COMM_H
#define SCREE_COMM_COMM_H

#include "base/error.h"
#include <mpi.h>
#include <stddef.h>
#include <stdint.h>

/* The ranks of a run. Only output/ (parallel HDF5) and comm/ use `handle`. */
struct comm {
    MPI_Comm handle; /* a duplicate of MPI_COMM_WORLD, errors returned */
    int rank, size;
    struct alone *alone; /* of comm_start; NULL on several ranks */
};

/* The tags of the communicator, one for each use. */
enum comm_tag {
    COMM_TAG_GATHER,
    COMM_TAG_SPARSE_EVEN, /* alternating rounds of exchanges without a plan (exchange.h) */
    COMM_TAG_SPARSE_ODD,
    COMM_TAG_FORWARD,
    COMM_TAG_REVERSE
};

/* Starts MPI (thread level FUNNELED), duplicates the communicator, sets the abort hook. comm_stop finalises.
 * A process that no mpirun or srun started does without Open MPI's daemon and networks (alone.h). Collective. */
void comm_start(struct comm *comm, int *argc, char ***argv);
void comm_stop(struct comm *comm);

/* The same in a program that is not scree's: a duplicate of the caller's communicator, at which `communicator` points
 * (an MPI_Comm). NULL: this process alone; if nobody has started MPI, MPI starts here and ends with the process.
 * False with a user's error if MPI is not there or has no threads. comm_leave frees the duplicate. Collective. */
bool comm_join(struct comm *comm, const void *communicator, struct error *error);
void comm_leave(struct comm *comm);

/* Ends the program on all ranks at once with this status (MPI_Abort). Any rank. */
_Noreturn void comm_abort(int status);

/* Ends the program with rank, call and MPI's text if `code`, which the MPI call named `call` returned, is an
 * error. */
void comm_check(int code, const char *call);

/* Turns an error of any rank into the same error on all: that of the lowest rank that has one. Returns true
 * if no rank has an error. Collective. */
bool comm_agree(const struct comm *comm, struct error *error);

/* Sends `bytes` bytes at `data` from rank 0 to all. Any number of bytes, the same on all ranks. Collective.
 */
void comm_broadcast(const struct comm *comm, void *data, size_t bytes);

/* Elementwise sums, maxima and minima over all ranks, in place, the result on every rank. Collective. */
void comm_sum(const struct comm *comm, double *values, int n);
void comm_max(const struct comm *comm, double *values, int n);
void comm_min(const struct comm *comm, double *values, int n);
void comm_sum_int(const struct comm *comm, int64_t *values, int n);
void comm_max_int(const struct comm *comm, int64_t *values, int n);

/* The two largest of all ranks' values, for each of the `n` pairs (largest, second largest), in place, the
 * result on every rank. If two ranks have the largest value, both members of the pair get it. Collective. */
void comm_max_two(const struct comm *comm, double (*values)[2], int n);

/* comm_max in two halves, so that other work can run between the halves; `values` may not be touched before
 * _end. One reduction at a time for each `reduction`. Collective. */
struct comm_reduction {
    MPI_Request request;
};
void comm_max_begin(const struct comm *comm, double *values, int n, struct comm_reduction *reduction);
void comm_max_end(struct comm_reduction *reduction);

/* Exclusive prefix sum over ranks of one value (0 on rank 0). Collective. */
int64_t comm_scan(const struct comm *comm, int64_t value);

/* Gathers `bytes` bytes from every rank, in rank order, into `all` (size x bytes) on every rank. Collective.
 */
void comm_gather_all(const struct comm *comm, const void *mine, size_t bytes, void *all);

/* Gathers a varying number of bytes from all ranks on rank 0: rank 0 allocates *all (memory_free) and fills
 * counts[size] if not NULL; other ranks get NULL and 0. Any number of bytes. Returns the total. Collective.
 */
size_t comm_gather_varying(const struct comm *comm, const void *mine, size_t bytes, void **all,
                           size_t *counts);

/* The same on every rank: all bytes, in rank order, to be freed (memory_free), and their number. Collective. */
void *comm_share(const struct comm *comm, const void *mine, size_t bytes, size_t *total);

#endif
