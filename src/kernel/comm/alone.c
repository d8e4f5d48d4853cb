/* SPDX-License-Identifier: BSD-3-Clause */
/* Starts MPI in a process without others. Read alone.h first. */
#include "kernel/comm/alone.h"

#include "base/memory.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { FOLDER, SETTINGS = 4 };

struct alone {
    char folder[256];
    bool set[SETTINGS];
};

static const char *const name[SETTINGS] = {[FOLDER] = "OMPI_MCA_orte_jobfam_session_dir",
                                           "OMPI_MCA_ess_singleton_isolated",
                                           "OMPI_MCA_pml",
                                           "OMPI_MCA_btl"};
static const char *const value[SETTINGS] = {NULL, "1", "ob1", "self"};

static bool is_launched(void) {
    return getenv("OMPI_COMM_WORLD_SIZE") || getenv("PMIX_RANK") || getenv("PMI_RANK");
}

struct alone *alone_begin(void) {
    const char *base = getenv("TMPDIR");
    struct alone *alone = NULL;
    if (is_launched())
        return NULL;
    alone = memory_allocate_zero(1, sizeof *alone, "start of MPI");
    int length =
        snprintf(alone->folder, sizeof alone->folder, "%s/scree-XXXXXX", base && *base ? base : "/tmp");
    if (length >= (int)sizeof alone->folder || !mkdtemp(alone->folder)) {
        memory_free(alone);
        return NULL;
    }
    for (int k = 0; k < SETTINGS; k++) {
        alone->set[k] = !getenv(name[k]);
        if (alone->set[k])
            setenv(name[k], k == FOLDER ? alone->folder : value[k], 0);
    }
    return alone;
}

void alone_started(const struct alone *alone) {
    for (int k = 0; alone && k < SETTINGS; k++)
        if (alone->set[k])
            unsetenv(name[k]);
}

void alone_end(struct alone **alone) {
    static const char *const below[] = {"/1/0", "/1", ""};
    char path[sizeof(*alone)->folder + 8];
    if (!*alone)
        return;
    for (int k = 0; k < 3; k++) {
        snprintf(path, sizeof path, "%s%s", (*alone)->folder, below[k]);
        rmdir(path);
    }
    memory_free(*alone);
    *alone = NULL;
}
