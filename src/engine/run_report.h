/* SPDX-License-Identifier: BSD-3-Clause */
/* The report of a run at its end (data/observe/report.h): its rows, and its lines on the terminal. */
#ifndef SCREE_ENGINE_RUN_REPORT_H
#define SCREE_ENGINE_RUN_REPORT_H

#include "engine/run_record.h"
#include "engine/run_stages.h"
#include "data/observe/report_print.h"

/* All entries, in the order of report.json, and the lines on the terminal. */
extern const struct report_row run_report_rows[];
extern const struct report_line run_report_lines[];

/* Begins the record of a loop of steps, which starts now, after `step` steps; timers are cleared. */
void run_report_begin(struct timers *timers, const struct ghosts *ghosts, uint64_t step,
                      struct run_record *run);

/* Makes the report of a run, or of the last of the stages in `chain` (NULL: the scene has none); report_destroy frees
 * it. Collective: all ranks call, outside parallel regions; each may have chosen another index and other levels. */
void run_report_make(const struct simulation *simulation, const struct run_record *run,
                     const struct run_chain *chain, struct report *report);

#endif
