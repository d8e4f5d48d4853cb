/* SPDX-License-Identifier: BSD-3-Clause */
/* scree report: a run or an ablation as a page for browsers, made by src/page/report.py. */
#ifndef SCREE_APP_PAGE_H
#define SCREE_APP_PAGE_H

#include "app/command_line.h"
#include "files/file.h"

/* Finds the folder with a file of a page: beside the program where it was built, else where `make install` puts it. Without the
 * file a user's error. */
bool page_folder(const char *file, char folder[FILE_PATH_MAX], struct error *error);

/* Writes the page. Without Python 3, or its script, a user's error. Returns the exit status, or fills the error. */
int command_report(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
