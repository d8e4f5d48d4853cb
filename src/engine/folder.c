#include "engine/folder.h"
#include "formats/checkpoint.h"
#include "files/file.h"
#include <errno.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

bool folder_lock(const struct comm *comm, const char *directory, int *handle, struct error *error) {
    *handle = -1;
    if (comm->rank == 0) {
        *handle = open(directory, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (*handle < 0)
            error_set_errno(error, "%s: cannot be opened", directory);
        else if (flock(*handle, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
            error_set(error, ERROR_USER, "%s: another run is writing to this directory; nothing was written",
                      directory);
    }
    if (comm_agree(comm, error))
        return true;
    folder_unlock(handle);
    return false;
}

void folder_unlock(int *handle) {
    if (*handle >= 0)
        close(*handle);
    *handle = -1;
}

bool folder_clear(const struct comm *comm, const char *directory, struct error *error) {
    static const char *const names[] = {"trajectory.h5", "trajectory.xdmf", "dump.lammpstrj",
                                        "observables.csv", "report.json"};
    char path[FILE_PATH_MAX];
    for (size_t k = 0; comm->rank == 0 && k < sizeof names / sizeof names[0]; k++)
        if (file_join(path, directory, names[k], error) && unlink(path) != 0 && errno != ENOENT)
            error_set_errno(error, "%s: cannot be replaced", path);
    if (comm->rank == 0 && error->kind == ERROR_NONE)
        checkpoint_discard(directory, -1, error);
    return comm_agree(comm, error);
}

bool folder_rewind(const struct comm *comm, const char *directory, uint64_t step, struct error *error) {
    if (comm->rank == 0)
        checkpoint_discard(directory, (int64_t)step, error);
    return comm_agree(comm, error);
}
