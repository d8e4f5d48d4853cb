/* SPDX-License-Identifier: BSD-3-Clause */
/* Single numbers and texts of the files of a run, for scripts: `scree info FILE --get KEY` and `scree info FILE
 * --column NAME --row ROW`. A folder stands for its report.json, or its observables.csv. */
#ifndef SCREE_PROGRAM_LOOKUP_H
#define SCREE_PROGRAM_LOOKUP_H

#include "base/error.h"
#include <stdio.h>

/* Prints the value at a key of a report.json ("pairs", "stages.contact.seconds", "solvers[0].name") as it stands in the
 * file. A name without a path is found below the top, too, if one value alone has that name. False with a user's error
 * that names what there is. */
bool lookup_key(const char *path, const char *key, FILE *out, struct error *error);

/* Prints a column of a table with commas and a line of heads ("energy_kinetic", with its unit or without) as it stands
 * in the file. `row`: a number from 0, negative from the end; "first", "last", or NULL: all rows, one a line. False
 * with a user's error. */
bool lookup_column(const char *path, const char *name, const char *row, FILE *out, struct error *error);

#endif
