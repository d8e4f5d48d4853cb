/* SPDX-License-Identifier: BSD-3-Clause */
/* What a loop of steps keeps for its report (run_report.h). */
#ifndef SCREE_ENGINE_RUN_RECORD_H
#define SCREE_ENGINE_RUN_RECORD_H

#include "base/timer.h"
#include "kernel/comm/ghosts.h"

struct run_record {
    uint64_t first;              /* step before the loop */
    double began, setup;         /* seconds: clock at the start of the loop; time before the loop */
    struct timers start;         /* stages before the loop */
    double particle_steps;       /* sum over steps of the particles moved */
    struct ghosts_counts before; /* counts before the loop: those of set-up */
    int stopped;                 /* signal that ended the loop; 0: none */
};

#endif
