/* SPDX-License-Identifier: BSD-3-Clause */
/* Checks and makes the directory of a run. Read run.h first. */
#include "engine/run.h"
#include "engine/folder.h"
#include <errno.h>
#include <string.h>
#include <sys/stat.h>

bool run_directory_suits(const struct comm *comm, const struct run_options *options, struct error *error) {
    if (options->directory == NULL)
        return true;
    if (options->directory[0] == '\0')
        return error_set(error, ERROR_USER, "command line: -o: the name of the directory is empty");
    return folder_check(comm, options->directory, error);
}

bool run_directory(const struct comm *comm, const struct run_options *options, struct error *error) {
    if (!run_directory_suits(comm, options, error))
        return false;
    if (comm->rank == 0 && options->directory) {
        struct stat found;
        bool there = stat(options->directory, &found) == 0;
        if (there && !options->overwrite && !options->resume && !folder_empty(options->directory))
            error_set(error, ERROR_USER,
                      "%s: exists already, and is not empty; nothing was written. Choose another -o, or give "
                      "--overwrite or "
                      "--resume FILE",
                      options->directory);
        else if (!there && !folder_make(options->directory))
            error_set(error, ERROR_USER, "%s: cannot make this directory: %s", options->directory,
                      strerror(errno));
    }
    return comm_agree(comm, error);
}
