/* SPDX-License-Identifier: BSD-3-Clause */
/* A folder for a test's files that all ranks know: made before the test, removed with its files after. */
#ifndef SCREE_TESTS_MPI_FOLDER_H
#define SCREE_TESTS_MPI_FOLDER_H

#include "kernel/comm/comm.h"

enum { FOLDER_MAX = 512 };

struct folder {
    char path[FOLDER_MAX];
};

/* Makes a new folder below TMPDIR or /tmp; rank 0 makes the folder, all ranks know its name. Collective. */
void folder_make(struct folder *folder, const struct comm *comm);

/* Removes the folder with all its files (the folder has no folders). Collective. */
void folder_remove(struct folder *folder, const struct comm *comm);

/* "PATH/NAME" in `path` (FOLDER_MAX + 64 bytes); returns `path`. */
char *folder_file(const struct folder *folder, const char *name, char path[FOLDER_MAX + 64]);

/* Number of files in the folder. */
int folder_count(const struct folder *folder);

/* A comm of this rank alone. */
struct comm folder_self(void);

/* A comm of the first `size` ranks; on the others a comm of the others. Collective; _free releases the comm. */
struct comm folder_first(const struct comm *comm, int size);
void folder_first_free(struct comm *comm);

#endif
