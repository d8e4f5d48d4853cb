/* SPDX-License-Identifier: BSD-3-Clause */
/* Start and end of MPI, and collective sums, maxima and gathers, each checked. Read comm.h first. */
#include "kernel/comm/comm.h"

#include "kernel/comm/alone.h"
#include "base/memory.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* MPI counts are ints: longer messages go in pieces. */
static const size_t piece_bytes = (size_t)1 << 30;

void comm_check(int code, const char *call) {
    if (code == MPI_SUCCESS)
        return;
    char text[MPI_MAX_ERROR_STRING];
    int length = 0;
    if (MPI_Error_string(code, text, &length) != MPI_SUCCESS)
        snprintf(text, sizeof text, "error code %d", code);
    error_fatal("%s failed: %s", call, text);
}

void comm_start(struct comm *comm, int *argc, char ***argv) {
    int provided = MPI_THREAD_SINGLE;
    comm->alone = alone_begin();
    comm_check(MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided), "MPI_Init_thread");
    alone_started(comm->alone);
    comm_check(MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
    comm_check(MPI_Comm_dup(MPI_COMM_WORLD, &comm->handle), "MPI_Comm_dup");
    comm_check(MPI_Comm_set_errhandler(comm->handle, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
    comm_check(MPI_Comm_rank(comm->handle, &comm->rank), "MPI_Comm_rank");
    comm_check(MPI_Comm_size(comm->handle, &comm->size), "MPI_Comm_size");
    error_set_abort(comm->rank, comm_abort);
    if (provided < MPI_THREAD_FUNNELED)
        error_fatal("this MPI offers no threads beside it (MPI_THREAD_FUNNELED)");
}

void comm_stop(struct comm *comm) {
    comm_check(MPI_Comm_free(&comm->handle), "MPI_Comm_free");
    error_set_abort(comm->rank, NULL);
    comm_check(MPI_Finalize(), "MPI_Finalize");
    alone_end(&comm->alone);
}

/* Of an MPI that comm_join has started; the process ends it. */
static struct alone *alone_here;

static void end_with_process(void) {
    int over = 1;
    if (MPI_Finalized(&over) == MPI_SUCCESS && !over)
        MPI_Finalize();
    alone_end(&alone_here);
}

static bool start_with_process(const void *communicator, struct error *error) {
    int started = 0, over = 0, provided;
    comm_check(MPI_Initialized(&started), "MPI_Initialized");
    comm_check(MPI_Finalized(&over), "MPI_Finalized");
    if (over)
        return error_set(error, ERROR_USER, "MPI has ended in this process, and cannot start again");
    if (started)
        return true;
    if (communicator)
        return error_set(error, ERROR_USER, "there is a communicator, but MPI was not started");
    alone_here = alone_begin();
    comm_check(MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &provided), "MPI_Init_thread");
    alone_started(alone_here);
    return atexit(end_with_process) == 0 ||
           error_set(error, ERROR_SYSTEM, "the end of MPI cannot be left to the end of the process");
}

bool comm_join(struct comm *comm, const void *communicator, struct error *error) {
    int provided = MPI_THREAD_SINGLE;
    *comm = (struct comm){0};
    if (!start_with_process(communicator, error))
        return false;
    comm_check(MPI_Query_thread(&provided), "MPI_Query_thread");
    if (provided < MPI_THREAD_FUNNELED)
        return error_set(error, ERROR_USER,
                         "MPI was started without threads; start it by MPI_Init_thread with at least "
                         "MPI_THREAD_FUNNELED");
    MPI_Comm given = communicator ? *(const MPI_Comm *)communicator : MPI_COMM_SELF;
    comm_check(MPI_Comm_dup(given, &comm->handle), "MPI_Comm_dup");
    comm_check(MPI_Comm_set_errhandler(comm->handle, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
    comm_check(MPI_Comm_rank(comm->handle, &comm->rank), "MPI_Comm_rank");
    comm_check(MPI_Comm_size(comm->handle, &comm->size), "MPI_Comm_size");
    error_set_abort(comm->rank, comm_abort);
    return true;
}

void comm_leave(struct comm *comm) {
    int over = 0;
    comm_check(MPI_Finalized(&over), "MPI_Finalized");
    if (!over)
        comm_check(MPI_Comm_free(&comm->handle), "MPI_Comm_free");
}

void comm_abort(int status) {
    MPI_Abort(MPI_COMM_WORLD, status);
    _Exit(status);
}

bool comm_agree(const struct comm *comm, struct error *error) {
    int first = error->kind != ERROR_NONE ? comm->rank : comm->size;
    comm_check(MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, comm->handle), "MPI_Allreduce");
    if (first == comm->size)
        return true;
    int kind = error->kind;
    comm_check(MPI_Bcast(&kind, 1, MPI_INT, first, comm->handle), "MPI_Bcast");
    comm_check(MPI_Bcast(error->text, ERROR_TEXT_MAX, MPI_CHAR, first, comm->handle), "MPI_Bcast");
    error->kind = (enum error_kind)kind;
    return false;
}

void comm_broadcast(const struct comm *comm, void *data, size_t bytes) {
    for (size_t done = 0; done < bytes; done += piece_bytes) {
        size_t piece = bytes - done < piece_bytes ? bytes - done : piece_bytes;
        comm_check(MPI_Bcast((char *)data + done, (int)piece, MPI_BYTE, 0, comm->handle), "MPI_Bcast");
    }
}

static void reduce(const struct comm *comm, void *values, int n, MPI_Datatype type, MPI_Op op) {
    comm_check(MPI_Allreduce(MPI_IN_PLACE, values, n, type, op, comm->handle), "MPI_Allreduce");
}

void comm_sum(const struct comm *comm, double *values, int n) {
    reduce(comm, values, n, MPI_DOUBLE, MPI_SUM);
}

void comm_max(const struct comm *comm, double *values, int n) {
    reduce(comm, values, n, MPI_DOUBLE, MPI_MAX);
}

void comm_min(const struct comm *comm, double *values, int n) {
    reduce(comm, values, n, MPI_DOUBLE, MPI_MIN);
}

void comm_sum_int(const struct comm *comm, int64_t *values, int n) {
    reduce(comm, values, n, MPI_INT64_T, MPI_SUM);
}

void comm_max_int(const struct comm *comm, int64_t *values, int n) {
    reduce(comm, values, n, MPI_INT64_T, MPI_MAX);
}

/* MPI_User_function: merges pairs of largest and second largest. */
static void merge_two(void *in, void *inout, int *length, MPI_Datatype *type) {
    const double(*other)[2] = in;
    double(*mine)[2] = inout;
    (void)type;
    for (int k = 0; k < *length; k++) {
        double largest = fmax(mine[k][0], other[k][0]);
        double second = fmax(fmin(mine[k][0], other[k][0]), fmax(mine[k][1], other[k][1]));
        mine[k][0] = largest;
        mine[k][1] = second;
    }
}

void comm_max_two(const struct comm *comm, double (*values)[2], int n) {
    MPI_Datatype pair;
    MPI_Op operation;
    comm_check(MPI_Type_contiguous(2, MPI_DOUBLE, &pair), "MPI_Type_contiguous");
    comm_check(MPI_Type_commit(&pair), "MPI_Type_commit");
    comm_check(MPI_Op_create(merge_two, 1, &operation), "MPI_Op_create");
    comm_check(MPI_Allreduce(MPI_IN_PLACE, values, n, pair, operation, comm->handle), "MPI_Allreduce");
    comm_check(MPI_Op_free(&operation), "MPI_Op_free");
    comm_check(MPI_Type_free(&pair), "MPI_Type_free");
}

void comm_max_begin(const struct comm *comm, double *values, int n, struct comm_reduction *reduction) {
    comm_check(
        MPI_Iallreduce(MPI_IN_PLACE, values, n, MPI_DOUBLE, MPI_MAX, comm->handle, &reduction->request),
        "MPI_Iallreduce");
}

void comm_max_end(struct comm_reduction *reduction) {
    comm_check(MPI_Wait(&reduction->request, MPI_STATUS_IGNORE), "MPI_Wait");
}

int64_t comm_scan(const struct comm *comm, int64_t value) {
    int64_t before = 0;
    comm_check(MPI_Exscan(&value, &before, 1, MPI_INT64_T, MPI_SUM, comm->handle), "MPI_Exscan");
    return comm->rank == 0 ? 0 : before;
}

void comm_gather_all(const struct comm *comm, const void *mine, size_t bytes, void *all) {
    if (bytes > INT_MAX)
        error_fatal("comm_gather_all of %zu bytes a rank: at most %d are possible", bytes, INT_MAX);
    comm_check(MPI_Allgather(mine, (int)bytes, MPI_BYTE, all, (int)bytes, MPI_BYTE, comm->handle),
               "MPI_Allgather");
}

static void send_to_root(const struct comm *comm, const char *data, size_t bytes) {
    for (size_t done = 0; done < bytes; done += piece_bytes) {
        size_t piece = bytes - done < piece_bytes ? bytes - done : piece_bytes;
        comm_check(MPI_Send(data + done, (int)piece, MPI_BYTE, 0, COMM_TAG_GATHER, comm->handle), "MPI_Send");
    }
}

static void receive_at_root(const struct comm *comm, int source, char *data, size_t bytes) {
    for (size_t done = 0; done < bytes; done += piece_bytes) {
        size_t piece = bytes - done < piece_bytes ? bytes - done : piece_bytes;
        MPI_Status status;
        comm_check(
            MPI_Recv(data + done, (int)piece, MPI_BYTE, source, COMM_TAG_GATHER, comm->handle, &status),
            "MPI_Recv");
        int got = 0;
        comm_check(MPI_Get_count(&status, MPI_BYTE, &got), "MPI_Get_count");
        if ((size_t)got != piece)
            error_fatal("MPI_Recv: rank %d sent %d bytes where %zu were announced", source, got, piece);
    }
}

size_t comm_gather_varying(const struct comm *comm, const void *mine, size_t bytes, void **all,
                           size_t *counts) {
    *all = NULL;
    uint64_t own = bytes;
    uint64_t *announced = NULL;
    if (comm->rank == 0)
        announced = memory_allocate((size_t)comm->size, sizeof *announced, "sizes to gather");
    comm_check(MPI_Gather(&own, 1, MPI_UINT64_T, announced, 1, MPI_UINT64_T, 0, comm->handle), "MPI_Gather");
    if (comm->rank != 0) {
        send_to_root(comm, mine, bytes);
        return 0;
    }
    size_t total = 0;
    for (int r = 0; r < comm->size; r++) {
        total += announced[r];
        if (counts != NULL)
            counts[r] = announced[r];
    }
    char *data = memory_allocate(total, 1, "gathered data");
    if (bytes > 0)
        memcpy(data, mine, bytes);
    size_t at = bytes;
    for (int r = 1; r < comm->size; r++) {
        receive_at_root(comm, r, data + at, announced[r]);
        at += announced[r];
    }
    memory_free(announced);
    *all = data;
    return total;
}

void *comm_share(const struct comm *comm, const void *mine, size_t bytes, size_t *total) {
    void *all;
    *total = comm_gather_varying(comm, mine, bytes, &all, NULL);
    comm_broadcast(comm, total, sizeof *total);
    if (comm->rank != 0)
        all = memory_allocate(*total, 1, "shared data");
    comm_broadcast(comm, all, *total);
    return all;
}
