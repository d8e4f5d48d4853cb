/* SPDX-License-Identifier: BSD-3-Clause */
/* `scree check`. */
#ifndef SCREE_APP_CHECK_H
#define SCREE_APP_CHECK_H

#include "app/command_line.h"

/* Reads and creates the scene of the line, prints what it needs and why, and runs nothing. Returns the exit
 * status, or that of the filled error. Collective. */
int command_check(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
