/* SPDX-License-Identifier: BSD-3-Clause */
/* Intercepts MPI's calls on files and records failures. Read files.h first. */
#include "kernel/comm/files.h"

#include <mpi.h>
#include <stdbool.h>
#include <stddef.h>

static void (*watcher)(const char *what);
static unsigned long opened;

unsigned long files_opened(void) {
    return opened;
}

void files_watch(void (*failed)(const char *what)) {
    watcher = failed;
}

static int look(int code, const char *what) {
    if (watcher != NULL && code != MPI_SUCCESS)
        watcher(what);
    return code;
}

/* The bytes that a finished call moved too few, compared with `count` items of a type; 0 if the call does not
 * tell. */
static MPI_Count missing(const MPI_Status *status, MPI_Datatype type, int count) {
    int size = 0;
    MPI_Count bytes = 0;
    bool known = status != MPI_STATUS_IGNORE && PMPI_Type_size(type, &size) == MPI_SUCCESS &&
                 PMPI_Get_elements_x(status, MPI_BYTE, &bytes) == MPI_SUCCESS;
    return known ? (MPI_Count)size * count - bytes : 0;
}

static int look_written(int code, const MPI_Status *status, MPI_Datatype type, int count) {
    if (watcher != NULL && code == MPI_SUCCESS && missing(status, type, count) > 0)
        watcher("written");
    return look(code, "written");
}

/* Checks a read: missing bytes are allowed behind the end of the file. */
static int look_read(int code, MPI_File file, MPI_Offset offset, const MPI_Status *status, MPI_Datatype type,
                     int count) {
    if (watcher != NULL && code == MPI_SUCCESS && missing(status, type, count) > 0) {
        MPI_Offset end = 0;
        MPI_Count bytes = 0;
        if (PMPI_File_get_size(file, &end) != MPI_SUCCESS ||
            PMPI_Get_elements_x(status, MPI_BYTE, &bytes) != MPI_SUCCESS || offset + bytes < end)
            watcher("read");
    }
    return look(code, "read");
}

int MPI_File_open(MPI_Comm comm, const char *name, int mode, MPI_Info info, MPI_File *file) {
    opened++;
    int code = look(PMPI_File_open(comm, name, mode, info, file), "opened"), failed = code != MPI_SUCCESS;
    if (watcher == NULL || PMPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, comm) != MPI_SUCCESS)
        return code;
    /* closing is collective: after the failure of another rank, this rank's file must stay open */
    return failed && code == MPI_SUCCESS ? MPI_ERR_FILE : code;
}

int MPI_File_read_at(MPI_File file, MPI_Offset offset, void *data, int count, MPI_Datatype type,
                     MPI_Status *status) {
    int code = PMPI_File_read_at(file, offset, data, count, type, status);
    return look_read(code, file, offset, status, type, count);
}

int MPI_File_read_at_all(MPI_File file, MPI_Offset offset, void *data, int count, MPI_Datatype type,
                         MPI_Status *status) {
    int code = PMPI_File_read_at_all(file, offset, data, count, type, status);
    return look_read(code, file, offset, status, type, count);
}

int MPI_File_write_at(MPI_File file, MPI_Offset offset, const void *data, int count, MPI_Datatype type,
                      MPI_Status *status) {
    return look_written(PMPI_File_write_at(file, offset, data, count, type, status), status, type, count);
}

int MPI_File_write_at_all(MPI_File file, MPI_Offset offset, const void *data, int count, MPI_Datatype type,
                          MPI_Status *status) {
    return look_written(PMPI_File_write_at_all(file, offset, data, count, type, status), status, type, count);
}

int MPI_File_set_size(MPI_File file, MPI_Offset size) {
    return look(PMPI_File_set_size(file, size), "cut");
}

int MPI_File_sync(MPI_File file) {
    return look(PMPI_File_sync(file), "flushed");
}

int MPI_File_close(MPI_File *file) {
    return look(PMPI_File_close(file), "closed");
}
