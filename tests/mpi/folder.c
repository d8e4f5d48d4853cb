/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes and removes the folder of a test. Read folder.h first. */
#include "folder.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void folder_make(struct folder *folder, const struct comm *comm) {
    const char *base = getenv("TMPDIR");
    snprintf(folder->path, sizeof folder->path, "%.400s/scree-test-XXXXXX", base && base[0] ? base : "/tmp");
    if (comm->rank == 0 && !mkdtemp(folder->path))
        error_fatal("%s: cannot be made", folder->path);
    comm_broadcast(comm, folder->path, sizeof folder->path);
}

static int for_each_file(const struct folder *folder, int (*visit)(const char *path)) {
    DIR *directory = opendir(folder->path);
    int count = 0;
    if (!directory)
        return 0;
    for (const struct dirent *entry; (entry = readdir(directory)) != NULL;) {
        char path[FOLDER_MAX + 300];
        if (entry->d_name[0] == '.')
            continue;
        snprintf(path, sizeof path, "%s/%s", folder->path, entry->d_name);
        count++;
        if (visit)
            visit(path);
    }
    closedir(directory);
    return count;
}

void folder_remove(struct folder *folder, const struct comm *comm) {
    int64_t barrier = 0;
    comm_sum_int(comm, &barrier, 1);
    if (comm->rank != 0)
        return;
    for_each_file(folder, unlink);
    rmdir(folder->path);
}

char *folder_file(const struct folder *folder, const char *name, char path[FOLDER_MAX + 64]) {
    snprintf(path, FOLDER_MAX + 64, "%s/%s", folder->path, name);
    return path;
}

int folder_count(const struct folder *folder) {
    return for_each_file(folder, NULL);
}

struct comm folder_self(void) {
    return (struct comm){.handle = MPI_COMM_SELF, .size = 1};
}

struct comm folder_first(const struct comm *comm, int size) {
    struct comm part = {.size = size};
    if (MPI_Comm_split(comm->handle, comm->rank >= size, comm->rank, &part.handle) != MPI_SUCCESS ||
        MPI_Comm_rank(part.handle, &part.rank) != MPI_SUCCESS)
        error_fatal("the ranks cannot be split");
    return part;
}

void folder_first_free(struct comm *comm) {
    MPI_Comm_free(&comm->handle);
}
