/* SPDX-License-Identifier: BSD-3-Clause */
/* Stands between a program and MPI (LD_PRELOAD) and makes one write to a file end too early: a tool of
 * faults.sh.
 *
 *     CUT_RANK    whose write
 *     CUT_NUMBER  which of the writes of that rank, from 1 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <mpi.h>
#include <stdlib.h>

typedef int write_at(MPI_File, MPI_Offset, const void *, int, MPI_Datatype, MPI_Status *);

static int number_of(const char *name) {
    const char *text = getenv(name);
    return text ? atoi(text) : 0;
}

static int write_and_cut(const char *call, MPI_File file, MPI_Offset offset, const void *data, int count,
                         MPI_Datatype type, MPI_Status *status) {
    static int writes;
    write_at *real;
    int rank = -1;
    *(void **)&real = dlsym(RTLD_NEXT, call);
    int code = real(file, offset, data, count, type, status);
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == number_of("CUT_RANK") && ++writes == number_of("CUT_NUMBER") && status != MPI_STATUS_IGNORE)
        PMPI_Status_set_elements(status, MPI_BYTE, 0);
    return code;
}

int PMPI_File_write_at(MPI_File file, MPI_Offset offset, const void *data, int count, MPI_Datatype type,
                       MPI_Status *status) {
    return write_and_cut("PMPI_File_write_at", file, offset, data, count, type, status);
}

int PMPI_File_write_at_all(MPI_File file, MPI_Offset offset, const void *data, int count, MPI_Datatype type,
                           MPI_Status *status) {
    return write_and_cut("PMPI_File_write_at_all", file, offset, data, count, type, status);
}
