/* SPDX-License-Identifier: BSD-3-Clause */
/* scree report: a run or an ablation as a page for browsers, made by src/front/page/report.py. */
#ifndef SCREE_PROGRAM_PAGE_H
#define SCREE_PROGRAM_PAGE_H

#include "front/program/command_line.h"
#include "base/file.h"

/* Finds the folder with a file of a page: beside the program where it was built, else where `make install` puts it. Without the
 * file a user's error. */
bool page_folder(const char *file, char folder[FILE_PATH_MAX], struct error *error);

/* Writes the page. Without Python 3, or its script, a user's error. Returns the exit status, or fills the error. */
int command_report(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
