/* SPDX-License-Identifier: BSD-3-Clause */
/* Charges wall-clock time to the innermost stage. Read timer.h first. */
#include "core/timer.h"

#include <assert.h>
#include <string.h>
#include <time.h>

static const char *const stage_names[TIMER_STAGES] = {
    [TIMER_SETUP] = "setup",     [TIMER_ADVANCE] = "advance", [TIMER_CONTACT] = "contact",
    [TIMER_SWEEP] = "sweep",     [TIMER_WALL] = "wall",       [TIMER_COMM] = "comm",
    [TIMER_DECIDE] = "decide",   [TIMER_MIGRATE] = "migrate", [TIMER_REORDER] = "reorder",
    [TIMER_GHOSTS] = "ghosts",   [TIMER_INDEX] = "index",     [TIMER_PAIRS] = "pairs",
    [TIMER_HISTORY] = "history", [TIMER_OUTPUT] = "output",   [TIMER_OTHER] = "other",
};

double timer_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

const char *timer_stage_name(enum timer_stage stage) {
    assert(stage < TIMER_STAGES);
    return stage_names[stage];
}

enum timer_stage timer_stage_find(const char *name) {
    for (int k = 0; k < TIMER_STAGES; k++)
        if (strcmp(stage_names[k], name) == 0)
            return (enum timer_stage)k;
    return TIMER_OTHER;
}

/* Charges the time since the last change to the running stage, if there is one. */
static void charge(struct timers *timers) {
    double now = timer_now();
    if (timers->depth > 0) {
        timers->seconds[timers->stack[timers->depth - 1]] += now - timers->since;
    }
    timers->since = now;
}

void timer_start(struct timers *timers, enum timer_stage stage) {
    assert(timers->depth < (int)(sizeof timers->stack / sizeof timers->stack[0]));
    charge(timers);
    timers->stack[timers->depth++] = stage;
    timers->calls[stage]++;
}

void timer_stop(struct timers *timers, enum timer_stage stage) {
    assert(timers->depth > 0 && timers->stack[timers->depth - 1] == stage);
    (void)stage;
    charge(timers);
    timers->depth--;
}
