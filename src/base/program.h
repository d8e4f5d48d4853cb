/* SPDX-License-Identifier: BSD-3-Clause */
/* Other programs that scree starts and waits for: renderers, ffmpeg, gnuplot, Python, compilers. No shell is between, so names of files
 * may hold any letters. */
#ifndef SCREE_BASE_PROGRAM_H
#define SCREE_BASE_PROGRAM_H

#include "base/error.h"
#include <stdbool.h>

/* Runs a program, found along PATH, with the arguments argv[1] ... (argv[0] is its name, NULL ends the list), in the folder
 * `folder` (NULL: the present one), and waits for its end. A program that reads more than names from its arguments, as
 * POV-Ray does, gets plain names, of files in such a folder. Output and messages go to the file `told` (replaced; NULL: to those of scree). A program that is not there
 * is a user's error that names `package`, Debian's package with the program. If the program fails, the error (user) has the
 * end of `told`. One thread. */
bool program_run(const char *const argv[], const char *folder, const char *told, const char *package,
                 struct error *error);

#endif
