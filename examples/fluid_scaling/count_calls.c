/* SPDX-License-Identifier: BSD-3-Clause */
/* Stands between a program and MPI (LD_PRELOAD) and counts messages and reductions, those of PETSc and hypre too: a tool of
 * fluid.sh.
 *
 *     cc -shared -fPIC (mpicc) count_calls.c -o count_calls.so;  COUNT_FILE=counts mpirun -x LD_PRELOAD=... scree run ...
 *
 * At the end rank 0 appends a line to COUNT_FILE: ranks, messages sent by all ranks, by the rank that sends most, bytes likewise,
 * collective calls of a rank (a broadcast, a reduction, a gather and a barrier count one each). */
#include <mpi.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { SLOTS = 1 << 16 };
static int64_t messages, bytes, collectives;

/* The bytes of persistent requests: to be sent at each start. Open addressing; -1: none, a receive. */
static struct slot {
    MPI_Request request;
    int64_t bytes;
} slots[SLOTS];

static struct slot *slot_of(MPI_Request request) {
    size_t k = ((uintptr_t)request >> 4) % SLOTS;
    for (size_t tried = 0; tried < SLOTS; tried++, k = (k + 1) % SLOTS)
        if (slots[k].request == request || slots[k].request == NULL) {
            slots[k].request = request;
            return &slots[k];
        }
    abort();
}

static int64_t size_of(int count, MPI_Datatype type) {
    int size = 0;
    PMPI_Type_size(type, &size);
    return (int64_t)count * size;
}

static void sent(int64_t size) {
    messages++;
    bytes += size;
}

#define SEND(NAME)                                                                                           \
    int NAME(const void *data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm) {               \
        sent(size_of(count, type));                                                                          \
        return P##NAME(data, count, type, to, tag, comm);                                                    \
    }
SEND(MPI_Send)
SEND(MPI_Ssend)
SEND(MPI_Rsend)

#define BEGIN_SEND(NAME)                                                                                     \
    int NAME(const void *data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,                 \
             MPI_Request *request) {                                                                         \
        sent(size_of(count, type));                                                                          \
        return P##NAME(data, count, type, to, tag, comm, request);                                           \
    }
BEGIN_SEND(MPI_Isend)
BEGIN_SEND(MPI_Issend)
BEGIN_SEND(MPI_Irsend)

int MPI_Send_init(const void *data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
                  MPI_Request *request) {
    int status = PMPI_Send_init(data, count, type, to, tag, comm, request);
    slot_of(*request)->bytes = size_of(count, type);
    return status;
}

int MPI_Recv_init(void *data, int count, MPI_Datatype type, int from, int tag, MPI_Comm comm,
                  MPI_Request *request) {
    int status = PMPI_Recv_init(data, count, type, from, tag, comm, request);
    slot_of(*request)->bytes = -1;
    return status;
}

static void started(MPI_Request request) {
    int64_t size = slot_of(request)->bytes;
    if (size >= 0)
        sent(size);
}

int MPI_Start(MPI_Request *request) {
    started(*request);
    return PMPI_Start(request);
}

int MPI_Startall(int count, MPI_Request requests[]) {
    for (int k = 0; k < count; k++)
        started(requests[k]);
    return PMPI_Startall(count, requests);
}

int MPI_Allreduce(const void *from, void *to, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
    collectives++;
    return PMPI_Allreduce(from, to, count, type, op, comm);
}

int MPI_Iallreduce(const void *from, void *to, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm,
                   MPI_Request *request) {
    collectives++;
    return PMPI_Iallreduce(from, to, count, type, op, comm, request);
}

int MPI_Reduce(const void *from, void *to, int count, MPI_Datatype type, MPI_Op op, int root, MPI_Comm comm) {
    collectives++;
    return PMPI_Reduce(from, to, count, type, op, root, comm);
}

int MPI_Scan(const void *from, void *to, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
    collectives++;
    return PMPI_Scan(from, to, count, type, op, comm);
}

int MPI_Bcast(void *data, int count, MPI_Datatype type, int root, MPI_Comm comm) {
    collectives++;
    return PMPI_Bcast(data, count, type, root, comm);
}

int MPI_Barrier(MPI_Comm comm) {
    collectives++;
    return PMPI_Barrier(comm);
}

int MPI_Allgather(const void *from, int count, MPI_Datatype type, void *to, int count_to,
                  MPI_Datatype type_to, MPI_Comm comm) {
    collectives++;
    return PMPI_Allgather(from, count, type, to, count_to, type_to, comm);
}

int MPI_Allgatherv(const void *from, int count, MPI_Datatype type, void *to, const int counts[],
                   const int places[], MPI_Datatype type_to, MPI_Comm comm) {
    collectives++;
    return PMPI_Allgatherv(from, count, type, to, counts, places, type_to, comm);
}

int MPI_Alltoall(const void *from, int count, MPI_Datatype type, void *to, int count_to, MPI_Datatype type_to,
                 MPI_Comm comm) {
    collectives++;
    return PMPI_Alltoall(from, count, type, to, count_to, type_to, comm);
}

int MPI_Finalize(void) {
    int64_t mine[3] = {messages, bytes, collectives}, sum[3], most[3];
    int rank = 0, ranks = 1;
    const char *name = getenv("COUNT_FILE");
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    PMPI_Comm_size(MPI_COMM_WORLD, &ranks);
    PMPI_Reduce(mine, sum, 3, MPI_INT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
    PMPI_Reduce(mine, most, 3, MPI_INT64_T, MPI_MAX, 0, MPI_COMM_WORLD);
    FILE *file = rank == 0 && name != NULL ? fopen(name, "a") : NULL;
    if (file != NULL) {
        fprintf(file, "%d %lld %lld %lld %lld %lld\n", ranks, (long long)sum[0], (long long)most[0],
                (long long)sum[1], (long long)most[1], (long long)most[2]);
        fclose(file);
    }
    return PMPI_Finalize();
}
