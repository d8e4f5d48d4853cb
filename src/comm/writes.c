#include "comm/writes.h"

#include <mpi.h>
#include <stdbool.h>
#include <stddef.h>

static void (*watcher)(void);

void writes_watch(void (*cut)(void)) {
    watcher = cut;
}

/* A write of `count` of a type has ended so. */
static int look(int code, const MPI_Status *status, MPI_Datatype type, int count) {
    int size = 0;
    MPI_Count bytes = 0;
    if (watcher == NULL)
        return code;
    bool known = status != MPI_STATUS_IGNORE && PMPI_Type_size(type, &size) == MPI_SUCCESS &&
                 PMPI_Get_elements_x(status, MPI_BYTE, &bytes) == MPI_SUCCESS;
    if (code != MPI_SUCCESS || (known && bytes < (MPI_Count)size * count))
        watcher();
    return code;
}

int MPI_File_write_at(MPI_File file, MPI_Offset offset, const void *data, int count, MPI_Datatype type,
                      MPI_Status *status) {
    return look(PMPI_File_write_at(file, offset, data, count, type, status), status, type, count);
}

int MPI_File_write_at_all(MPI_File file, MPI_Offset offset, const void *data, int count, MPI_Datatype type,
                          MPI_Status *status) {
    return look(PMPI_File_write_at_all(file, offset, data, count, type, status), status, type, count);
}
