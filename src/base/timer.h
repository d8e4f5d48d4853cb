/* SPDX-License-Identifier: BSD-3-Clause */
/* Wall-clock timers per stage of a run, nested calls allowed. The parts of a run register their stages by
 * name; no stage is known here. One `struct timers` belongs to one simulation; only the main thread registers,
 * starts and stops. */
#ifndef SCREE_BASE_TIMER_H
#define SCREE_BASE_TIMER_H

#include <stdint.h>

enum { TIMER_STAGES_MAX = 32, TIMER_DEPTH_MAX = 16 };

/* The nature of a stage's time, bits. */
enum timer_use {
    TIMER_WORK = 1,    /* work of this rank, dealt out to its threads */
    TIMER_WAIT = 2,    /* communication, and waiting for other ranks */
    TIMER_REBUILD = 4, /* part of a rebuild */
    TIMER_START = 8    /* before the first step */
};

struct timer_stage {
    const char *name; /* as in report.json ("advance", "contact", ...); borrowed */
    const char *help; /* a description for people; borrowed */
    unsigned use;
    double seconds; /* without those of stages started inside the stage */
    uint64_t calls;
};

/* All zero: no stages. */
struct timers {
    int stages;
    struct timer_stage stage[TIMER_STAGES_MAX];
    int depth;
    int stack[TIMER_DEPTH_MAX];
    double since; /* when the running stage began or resumed */
};

/* Seconds since an arbitrary fixed moment; monotonic. Any thread. */
double timer_now(void);

/* Registers a stage behind those that there are; returns its number. A name that is known keeps its stage. */
int timer_register(struct timers *timers, const char *name, const char *help, unsigned use);

/* The number of a registered stage; -1 if there is none of that name. */
int timer_find(const struct timers *timers, const char *name);

/* Forgets all times and calls, but no stage. No stage may be running. */
void timer_clear(struct timers *timers);

/* Seconds of all stages that have all bits `with` and none of `without`. */
double timer_sum(const struct timers *timers, unsigned with, unsigned without);

/* timer_start starts a stage inside the running one, whose clock pauses; timer_stop ends the stage. */
void timer_start(struct timers *timers, int stage);
void timer_stop(struct timers *timers, int stage);

/* The same for a stage by its name; nothing where `timers` is NULL or has no such stage. */
void timer_enter(struct timers *timers, const char *name);
void timer_leave(struct timers *timers, const char *name);

#endif
