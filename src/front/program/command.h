/* SPDX-License-Identifier: BSD-3-Clause */
/* The subcommands: one table row a command. */
#ifndef SCREE_PROGRAM_COMMAND_H
#define SCREE_PROGRAM_COMMAND_H

#include "front/program/command_line.h"

/* The command with a name, or NULL; the k-th command, NULL after the last. */
const struct command *command_find(const char *name);
const struct command *command_get(int k);

/* Prints the value that --get or --column and --row of `scree info` ask for; needs no MPI. Returns the exit status, or
 * fills the error. */
int command_lookup(const struct command_line *line, struct error *error);

/* Prints the usage of all commands, or the full usage of one; with a topic, that topic of the command. False
 * if the topic does not exist. */
bool command_usage(FILE *out, const struct command *command, const char *topic);

#endif
