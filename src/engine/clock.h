/* SPDX-License-Identifier: BSD-3-Clause */
/* Steps and time of a run. */
#ifndef SCREE_ENGINE_CLOCK_H
#define SCREE_ENGINE_CLOCK_H

#include <stdint.h>

/* time = time_base + (step - step_base) dt. */
struct clock {
    uint64_t step; /* steps done; the one in progress counts as done */
    uint64_t step_base;
    double time, time_base, dt;
    double dt_fraction; /* dt as a fraction of the stable step; 0: the scene gives dt */
};

/* The time of a step. */
static inline double clock_time(const struct clock *clock, uint64_t step) {
    return clock->time_base + ((double)step - (double)clock->step_base) * clock->dt;
}

#endif
