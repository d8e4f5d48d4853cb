/* SPDX-License-Identifier: BSD-3-Clause */
/* scree picture. */
#ifndef SCREE_APP_PICTURE_H
#define SCREE_APP_PICTURE_H

#include "app/command_line.h"

/* Draws a run. Returns the exit status, or fills the error. */
int command_picture(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
