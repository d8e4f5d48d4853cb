/* SPDX-License-Identifier: BSD-3-Clause */
/* scree report: a run or an ablation as a page for browsers, made by src/page/report.py. */
#ifndef SCREE_APP_PAGE_H
#define SCREE_APP_PAGE_H

#include "app/command_line.h"

/* Writes the page. Without Python 3, or its script, a user's error. Returns the exit status, or fills the error. */
int command_report(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
