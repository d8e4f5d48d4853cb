/* SPDX-License-Identifier: BSD-3-Clause */
/* The report of a run at its end. */
#ifndef SCREE_ENGINE_RUN_REPORT_H
#define SCREE_ENGINE_RUN_REPORT_H

#include "engine/state.h"
#include "data/observe/report.h"

/* Data of the loop of steps for the report. */
struct run_record {
    uint64_t first;              /* step before the loop */
    double began, setup;         /* seconds: clock at the start of the loop; time before the loop */
    struct timers start;         /* stages before the loop */
    double particle_steps;       /* sum over steps of the particles moved */
    struct ghosts_counts before; /* counts before the loop: those of set-up */
    int stopped;                 /* signal that ended the loop; 0: none */
};

/* Fills a report that report_create made. Collective: all ranks call, outside parallel regions; each may have
 * chosen another index and other levels. */
void run_report_fill(const struct simulation *simulation, const struct run_record *run,
                     struct report *report);

#endif
