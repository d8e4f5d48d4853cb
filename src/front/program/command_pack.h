/* SPDX-License-Identifier: BSD-3-Clause */
/* `scree pack`. */
#ifndef SCREE_PROGRAM_COMMAND_PACK_H
#define SCREE_PROGRAM_COMMAND_PACK_H

#include "front/program/command_line.h"

/* Makes the packing of the command line and writes its files. Rank 0 works. Returns the exit status, or the
 * status of the filled error. Collective. */
int command_pack(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
