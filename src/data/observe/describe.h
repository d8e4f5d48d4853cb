/* SPDX-License-Identifier: BSD-3-Clause */
/* The tables of docs/output.md that follow from the field table, the registry of observables and the entries of
 * the report. */
#ifndef SCREE_OBSERVE_DESCRIBE_H
#define SCREE_OBSERVE_DESCRIBE_H

#include "base/error.h"
#include "base/timer.h"
#include "data/observe/report.h"
#include <stdbool.h>
#include <stdio.h>

/* The rows of a report, and the stages that it may have. */
struct describe_from {
    const struct report_row *rows;
    const struct timers *stages;
};

/* Copies a page and writes its tables again. A table is the text between a line "<!-- NAME: ... -->" and the
 * line "<!-- end of NAME -->"; NAME is "fields", "observables", "families" or "report". A name without its
 * end, and one of the four that the page does not have, are a user's error. One thread. */
bool describe_page(FILE *page, FILE *out, const struct describe_from *from, struct error *error);

#endif
