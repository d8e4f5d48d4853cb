/* SPDX-License-Identifier: BSD-3-Clause */
/* Checks, locks, clears and rewinds the folder of a run. Read folder.h first. */
#include "engine/folder.h"
#include "data/formats/checkpoint.h"
#include "data/formats/contact_problem.h"
#include "data/formats/wall_frames.h"
#include "base/file.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

/* The longest text that a run adds to the path of its directory. */
static const char longest[] = "/checkpoint-18446744073709551615" CHECKPOINT_STOPPED ".h5.part";

/* The parent of a directory. */
static void parent_of(const char *directory, char parent[FILE_PATH_MAX]) {
    snprintf(parent, FILE_PATH_MAX, "%s", directory);
    size_t length = strlen(parent);
    while (length > 0 && parent[length - 1] == '/')
        length--;
    while (length > 0 && parent[length - 1] != '/')
        length--;
    parent[length] = '\0';
    if (length == 0)
        snprintf(parent, FILE_PATH_MAX, ".");
}

static void check(const char *directory, struct error *error) {
    char parent[FILE_PATH_MAX];
    struct stat found;
    if (strlen(directory) + strlen(longest) >= FILE_PATH_MAX) {
        error_set(
            error, ERROR_USER,
            "%.100s...: the name of the directory has %zu characters; with the names of files in it the "
            "path may have %d, so %zu are allowed",
            directory, strlen(directory), FILE_PATH_MAX - 1, FILE_PATH_MAX - 1 - strlen(longest));
    } else if (stat(directory, &found) != 0) {
        parent_of(directory, parent);
        for (char above[FILE_PATH_MAX]; stat(parent, &found) != 0 && errno == ENOENT;) {
            parent_of(parent, above); /* is made, too */
            snprintf(parent, sizeof parent, "%s", above);
        }
        if (access(parent, W_OK | X_OK) != 0)
            error_set(error, ERROR_USER, "%s: cannot make this directory: %s: %s", directory, parent,
                      strerror(errno));
    } else if (!S_ISDIR(found.st_mode)) {
        error_set(error, ERROR_USER, "%s: exists and is not a directory", directory);
    } else if (access(directory, W_OK | X_OK) != 0) {
        error_set(error, ERROR_USER, "%s: nothing can be written to this directory: %s", directory,
                  strerror(errno));
    }
}

bool folder_empty(const char *directory) {
    DIR *open = opendir(directory);
    bool full = false;
    for (struct dirent *entry; open && !full && (entry = readdir(open));)
        full = strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    if (!open)
        return false;
    closedir(open);
    return !full;
}

bool folder_make(const char *directory) {
    char part[FILE_PATH_MAX];
    for (const char *slash = strchr(directory + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        snprintf(part, sizeof part, "%.*s", (int)(slash - directory), directory);
        if (mkdir(part, 0777) != 0 && errno != EEXIST)
            return false;
    }
    return mkdir(directory, 0777) == 0 || errno == EEXIST;
}

bool folder_check(const struct comm *comm, const char *directory, struct error *error) {
    if (comm->rank == 0)
        check(directory, error);
    return comm_agree(comm, error);
}

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
    static const char *const names[] = {"trajectory.h5",   "trajectory.xdmf", "dump.lammpstrj",
                                        "observables.csv", "report.json",     "walls.pvd",
                                        "walls.xdmf"};
    char path[FILE_PATH_MAX];
    for (size_t k = 0; comm->rank == 0 && k < sizeof names / sizeof names[0]; k++)
        if (file_join(path, directory, names[k], error) && unlink(path) != 0 && errno != ENOENT)
            error_set_errno(error, "%s: cannot be replaced", path);
    if (comm->rank == 0 && error->kind == ERROR_NONE) {
        wall_frames_discard(directory, -1);
        contact_problem_discard(directory, -1);
    }
    if (comm->rank == 0 && error->kind == ERROR_NONE)
        checkpoint_discard(directory, -1, error);
    return comm_agree(comm, error);
}

/* True if both begin with the same scene, or one does not tell. */
static bool same_beginning(const struct lineage *a, const struct lineage *b) {
    return a->count == 0 || b->count == 0 || strcmp(a->run[0].scene, b->run[0].scene) == 0;
}

bool folder_suits(const struct comm *comm, const char *directory, const struct lineage *lineage,
                  struct error *error) {
    for (size_t place = 0;; place++) {
        char path[FILE_PATH_MAX] = "";
        struct checkpoint_loaded head;
        struct error damaged = {0};
        if (comm->rank == 0 && !checkpoint_find(directory, place, path))
            path[0] = '\0';
        comm_broadcast(comm, path, sizeof path);
        if (path[0] == '\0')
            return true;
        if (!checkpoint_read_head(comm, path, &head, &damaged))
            continue;
        bool same = same_beginning(&head.lineage, lineage);
        checkpoint_loaded_free(&head);
        return same ||
               error_set(
                   error, ERROR_USER,
                   "%s: is of a run that began with another scene; nothing was written. Choose another -o",
                   path);
    }
}

bool folder_rewind(const struct comm *comm, const char *directory, uint64_t step, struct error *error) {
    if (comm->rank == 0)
        checkpoint_discard(directory, (int64_t)step, error);
    return comm_agree(comm, error);
}
