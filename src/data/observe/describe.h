/* SPDX-License-Identifier: BSD-3-Clause */
/* The tables of docs/output.md that follow from the field table, the registry of observables and the entries of
 * the report. */
#ifndef SCREE_OBSERVE_DESCRIBE_H
#define SCREE_OBSERVE_DESCRIBE_H

#include "base/error.h"
#include "base/timer.h"
#include <stdbool.h>
#include <stdio.h>

/* Copies a page and writes its tables again. A table is the text between a line "<!-- NAME: ... -->" and the
 * line "<!-- end of NAME -->"; NAME is "fields", "observables", "families" or "report". A name without its
 * end, and one of the four that the page does not have, are a user's error. `stages`: those that a report may have. One
 * thread. */
bool describe_page(FILE *page, FILE *out, const struct timers *stages, struct error *error);

#endif
