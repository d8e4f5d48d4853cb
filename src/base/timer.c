/* SPDX-License-Identifier: BSD-3-Clause */
/* Charges wall-clock time to the innermost stage. Read timer.h first. */
#include "base/timer.h"

#include <assert.h>
#include <string.h>
#include <time.h>

double timer_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int timer_find(const struct timers *timers, const char *name) {
    for (int k = 0; k < timers->stages; k++)
        if (strcmp(timers->stage[k].name, name) == 0)
            return k;
    return -1;
}

int timer_register(struct timers *timers, const char *name, const char *help, unsigned use) {
    int known = timer_find(timers, name);
    if (known >= 0)
        return known;
    assert(timers->stages < TIMER_STAGES_MAX);
    timers->stage[timers->stages] = (struct timer_stage){.name = name, .help = help, .use = use};
    return timers->stages++;
}

void timer_clear(struct timers *timers) {
    assert(timers->depth == 0);
    for (int k = 0; k < timers->stages; k++) {
        timers->stage[k].seconds = 0;
        timers->stage[k].calls = 0;
    }
}

double timer_sum(const struct timers *timers, unsigned with, unsigned without) {
    double seconds = 0;
    for (int k = 0; k < timers->stages; k++)
        if ((timers->stage[k].use & with) == with && (timers->stage[k].use & without) == 0)
            seconds += timers->stage[k].seconds;
    return seconds;
}

/* Charges the time since the last change to the running stage, if there is one. */
static void charge(struct timers *timers) {
    double now = timer_now();
    if (timers->depth > 0)
        timers->stage[timers->stack[timers->depth - 1]].seconds += now - timers->since;
    timers->since = now;
}

void timer_start(struct timers *timers, int stage) {
    assert(stage >= 0 && stage < timers->stages && timers->depth < TIMER_DEPTH_MAX);
    charge(timers);
    timers->stack[timers->depth++] = stage;
    timers->stage[stage].calls++;
}

void timer_stop(struct timers *timers, int stage) {
    assert(timers->depth > 0 && timers->stack[timers->depth - 1] == stage);
    (void)stage;
    charge(timers);
    timers->depth--;
}

void timer_enter(struct timers *timers, const char *name) {
    int stage = timers ? timer_find(timers, name) : -1;
    if (stage >= 0)
        timer_start(timers, stage);
}

void timer_leave(struct timers *timers, const char *name) {
    int stage = timers ? timer_find(timers, name) : -1;
    if (stage >= 0)
        timer_stop(timers, stage);
}
