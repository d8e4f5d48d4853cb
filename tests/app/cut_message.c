/* SPDX-License-Identifier: BSD-3-Clause */
/* Stands between a program and MPI (LD_PRELOAD) and makes one message too short or too long: a tool of
 * faults.sh.
 *
 *     CUT_CALL    MPI_Isend or MPI_Issend
 *     CUT_RANK    who sends the message
 *     CUT_NUMBER  which of the calls of that rank, from 1
 *     CUT_BYTES   how much longer it gets; negative: shorter */
#include <mpi.h>
#include <stdlib.h>
#include <string.h>

static int number_of(const char *name) {
    const char *text = getenv(name);
    return text ? atoi(text) : 0;
}

/* The bytes that this call is to send instead of `count`; `calls` counts those of its kind. */
static int bytes_of(const char *call, int *calls, int count) {
    const char *wanted = getenv("CUT_CALL");
    int rank = -1;
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (wanted == NULL || strcmp(wanted, call) != 0 || rank != number_of("CUT_RANK"))
        return count;
    if (++*calls != number_of("CUT_NUMBER"))
        return count;
    int bytes = count + number_of("CUT_BYTES");
    return bytes < 0 ? 0 : bytes;
}

/* A message that got longer needs room: a copy, which stays until the program ends. */
static const void *room_for(const void *data, int count, int bytes) {
    if (bytes <= count)
        return data;
    char *longer = calloc((size_t)bytes, 1);
    if (longer == NULL)
        abort();
    memcpy(longer, data, (size_t)count);
    return longer;
}

int MPI_Isend(const void *data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
              MPI_Request *request) {
    static int calls;
    int bytes = bytes_of("MPI_Isend", &calls, count);
    return PMPI_Isend(room_for(data, count, bytes), bytes, type, to, tag, comm, request);
}

int MPI_Issend(const void *data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
               MPI_Request *request) {
    static int calls;
    int bytes = bytes_of("MPI_Issend", &calls, count);
    return PMPI_Issend(room_for(data, count, bytes), bytes, type, to, tag, comm, request);
}
