/* SPDX-License-Identifier: BSD-3-Clause */
/* Parts of `scree ablate`: the tables, a run of a comparison, and the study of time against error. */
#ifndef SCREE_PROGRAM_ABLATE_PARTS_H
#define SCREE_PROGRAM_ABLATE_PARTS_H

#include "base/timer.h"
#include "data/observe/report.h"
#include "front/program/axis.h"
#include "engine/run.h"
#include "front/program/command_line.h"
#include <stdio.h>

struct ablate_tables {
    struct timers timers;    /* their stages are columns */
    const struct axis *axis; /* keys that vary and are columns; borrowed */
    int axes;
    FILE *csv, *json; /* rank 0 only, else NULL */
};

/* Makes the files, with the names of the columns. Fails (system). Rank 0 only. */
bool ablate_tables_open(struct ablate_tables *tables, const char *directory, struct error *error);

/* Writes and prints the row of a run with value `at[k]` of axis k. Rank 0 only. */
void ablate_tables_row(const struct ablate_tables *tables, const int *at, const struct report *report);

/* Closes the files that are open. Fails (system) if what was written is lost. */
void ablate_tables_close(struct ablate_tables *tables, const char *directory, struct error *error);

/* One run of a comparison, without files. */

/* Options of a run of a comparison: observer and progress. */
struct ablate_options {
    const struct run_watch *watch;
    const struct progress_series *series;
};

/* Runs a scene without files; members of `options` and `report` may be NULL. With a series progress is shown.
 * A signal that ends the run is an error of kind ERROR_SIGNAL + number. Collective. */
bool ablate_run(const struct comm *comm, const struct scene *scene, const struct ablate_options *options,
                struct report *report, struct error *error);

/* `scree ablate --error`: settings by time and by error. */

/* Runs the study of the command line, whose directory must exist, and writes the tables (speed_error.h).
 * Collective. */
bool ablate_error(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
