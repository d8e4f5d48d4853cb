/* The tables of docs/output.md that follow from the field table and the registry of observables. */
#ifndef SCREE_OBSERVE_DESCRIBE_H
#define SCREE_OBSERVE_DESCRIBE_H

#include "core/error.h"
#include <stdbool.h>
#include <stdio.h>

/* Copies a page, with the tables made anew: what stands between a line "<!-- NAME: ... -->" and the line
 * "<!-- end of NAME -->", where NAME is "fields", "observables" or "families". A name without its end, and
 * one of the three that the page does not have, are a user's error. One thread. */
bool describe_page(FILE *page, FILE *out, struct error *error);

#endif
