/* SPDX-License-Identifier: BSD-3-Clause */
/* Other programs that scree starts and waits for: renderers, ffmpeg, Python. */
#ifndef SCREE_FILES_PROGRAM_H
#define SCREE_FILES_PROGRAM_H

#include "core/error.h"
#include <stdbool.h>

/* Runs a program, found along PATH, with the arguments argv[1] ... (argv[0] is its name, NULL ends the list), and waits
 * for its end. Output and messages go to the file `told` (replaced; NULL: to those of scree). A program that is not there
 * is a user's error that names `package`, Debian's package with the program. If the program fails, the error (user) has the
 * end of `told`. One thread. */
bool program_run(const char *const argv[], const char *told, const char *package, struct error *error);

#endif
