/* SPDX-License-Identifier: BSD-3-Clause */
/* `scree check`. */
#ifndef SCREE_PROGRAM_CHECK_H
#define SCREE_PROGRAM_CHECK_H

#include "front/program/command_line.h"

/* Reads the scene of the command line and creates its simulation, prints the parts that the scene needs and
 * the reasons, and runs no step. Returns the exit status, or the status of the filled error. Collective. */
int command_check(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
