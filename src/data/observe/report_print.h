/* SPDX-License-Identifier: BSD-3-Clause */
/* The report on the terminal. */
#ifndef SCREE_OBSERVE_REPORT_PRINT_H
#define SCREE_OBSERVE_REPORT_PRINT_H

#include "data/observe/report.h"
#include <stdio.h>

/* Prints the report as readable lines and tables. One rank calls. */
void report_print(const struct report *report, FILE *file);

#endif
