/* SPDX-License-Identifier: BSD-3-Clause */
/* The tables of `scree ablate`: DIR/ablate.csv, and DIR/ablate.jsonl with the same in lines of JSON. A row a run. */
#ifndef SCREE_PROGRAM_ABLATE_TABLE_H
#define SCREE_PROGRAM_ABLATE_TABLE_H

#include "base/timer.h"
#include "data/observe/report.h"
#include "front/program/axis.h"
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

#endif
