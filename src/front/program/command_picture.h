/* SPDX-License-Identifier: BSD-3-Clause */
/* scree picture. */
#ifndef SCREE_PROGRAM_COMMAND_PICTURE_H
#define SCREE_PROGRAM_COMMAND_PICTURE_H

#include "front/program/command_line.h"

/* Draws a run. Returns the exit status, or fills the error. */
int command_picture(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
