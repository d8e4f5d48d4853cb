/* SPDX-License-Identifier: BSD-3-Clause */
/* The report on the terminal. */
#ifndef SCREE_OBSERVE_REPORT_PRINT_H
#define SCREE_OBSERVE_REPORT_PRINT_H

#include "data/observe/report.h"
#include <stdio.h>

/* A line on the terminal; of a list, a line an entry. The text has the values of rows by their names: "{pairs}", or
 * "{pairs:12}" with a width, negative for text at the left; "{#}" is the number of the entry. */
struct report_line {
    const char *text;    /* NULL behind the last line */
    const char *when;    /* a row of the report: shown if report_holds; NULL: always */
    const char *list;    /* NULL: a line of the report itself */
    const char *heading; /* before the first entry; NULL: none */
    const char *only;    /* a row of the list: shown if report_holds; NULL: each entry */
};

/* Prints the lines of a report. One rank calls. */
void report_print(const struct report *report, const struct report_line *lines, FILE *file);

#endif
