/* SPDX-License-Identifier: BSD-3-Clause */
/* `scree ablate`: variants of one scene, run one after the other in this process. */
#ifndef SCREE_PROGRAM_ABLATE_H
#define SCREE_PROGRAM_ABLATE_H

#include "front/program/command_line.h"

/* Runs the scene of the line over indexes, threads and newton settings, or (--error) over settings that
 * change the error, and writes the tables into the directory of the line. Returns the exit status, or the
 * status of the filled error. Collective. */
int command_ablate(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
