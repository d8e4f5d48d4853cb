/* SPDX-License-Identifier: BSD-3-Clause */
/* DIR/report.json. */
#ifndef SCREE_OBSERVE_REPORT_JSON_H
#define SCREE_OBSERVE_REPORT_JSON_H

#include "base/error.h"
#include "data/observe/report.h"
#include <stdio.h>

/* Writes a text as a JSON string. */
void report_json_text(FILE *file, const char *text);

/* Writes the report as a JSON object. */
void report_json(const struct report *report, FILE *file);

/* Writes the report to `path` (rank 0 alone calls) by a temporary name. Fails (system) where it cannot be written. */
bool report_write_json(const struct report *report, const char *path, struct error *error);

#endif
