/* SPDX-License-Identifier: BSD-3-Clause */
/* `scree ablate --error`: settings by time and by error. */
#ifndef SCREE_PROGRAM_ABLATE_ERROR_H
#define SCREE_PROGRAM_ABLATE_ERROR_H

#include "front/program/command_line.h"

/* Runs the study of the command line, whose directory must exist, and writes the tables (speed_error.h).
 * Collective. */
bool ablate_error(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
