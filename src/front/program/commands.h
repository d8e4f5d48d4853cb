/* SPDX-License-Identifier: BSD-3-Clause */
/* The commands of the program: what command.c and scree_main.c call, a function a command. */
#ifndef SCREE_FRONT_PROGRAM_COMMANDS_H
#define SCREE_FRONT_PROGRAM_COMMANDS_H

#include "base/error.h"
#include "base/file.h"
#include "front/program/command_line.h"

#include <stdio.h>

/* `scree ablate`: variants of one scene, run one after the other in this process. */

/* Runs the scene of the line over indexes, threads and newton settings, or (--error) over settings that
 * change the error, and writes the tables into the directory of the line. Returns the exit status, or the
 * status of the filled error. Collective. */
int command_ablate(const struct comm *comm, const struct command_line *line, struct error *error);

/* `scree check`. */

/* Reads the scene of the command line and creates its simulation, prints the parts that the scene needs and
 * the reasons, and runs no step. Returns the exit status, or the status of the filled error. Collective. */
int command_check(const struct comm *comm, const struct command_line *line, struct error *error);

/* `scree pack`. */

/* Makes the packing of the command line and writes its files. Rank 0 works. Returns the exit status, or the
 * status of the filled error. Collective. */
int command_pack(const struct comm *comm, const struct command_line *line, struct error *error);

/* scree picture. */

/* Draws a run. Returns the exit status, or fills the error. */
int command_picture(const struct comm *comm, const struct command_line *line, struct error *error);

/* Single numbers and texts of the files of a run, for scripts: `scree info FILE --get KEY` and `scree info FILE
 * --column NAME --row ROW`. A folder stands for its report.json, or its observables.csv. */

/* Prints the value at a key of a report.json ("pairs", "stages.contact.seconds", "solvers[0].name") as it stands in the
 * file. A name without a path is found below the top, too, if one value alone has that name. False with a user's error
 * that names what there is. */
bool lookup_key(const char *path, const char *key, FILE *out, struct error *error);

/* Prints a column of a table with commas and a line of heads ("energy_kinetic", with its unit or without) as it stands
 * in the file. `row`: a number from 0, negative from the end; "first", "last", or NULL: all rows, one a line. False
 * with a user's error. */
bool lookup_column(const char *path, const char *name, const char *row, FILE *out, struct error *error);

/* The manual page and the completion of the shell, from the tables of commands and flags. */

/* Prints the manual page scree(1) in the language man, for `scree help --man`. */
void manual_page(FILE *out);

/* Prints the completion of bash, for `scree help --bash`. */
void manual_bash(FILE *out);

/* Prints the completion of zsh and of fish, for `scree help --zsh` and `--fish`. */
void manual_zsh(FILE *out);
void manual_fish(FILE *out);

/* scree report: a run or an ablation as a page for browsers, made by src/front/page/report.py. */

/* Finds the folder with a file of a page: beside the program where it was built, else where `make install` puts it. Without the
 * file a user's error. */
bool page_folder(const char *file, char folder[FILE_PATH_MAX], struct error *error);

/* Writes the page. Without Python 3, or its script, a user's error. Returns the exit status, or fills the error. */
int command_report(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
