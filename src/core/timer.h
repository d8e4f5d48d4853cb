/* SPDX-License-Identifier: BSD-3-Clause */
/* Wall-clock timers per stage of a run, nested calls allowed. One `struct timers` belongs to one simulation;
 * only the main thread starts and stops. */
#ifndef SCREE_CORE_TIMER_H
#define SCREE_CORE_TIMER_H

#include <stdint.h>

/* The stages of a run, in report order. A stage's time excludes that of stages started inside it. */
enum timer_stage {
    TIMER_SETUP,   /* reading the scene and making particles */
    TIMER_ADVANCE, /* kick and drift */
    TIMER_SWEEP,   /* fused: drift and particle-particle forces, block by block */
    TIMER_CONTACT, /* particle-particle forces */
    TIMER_WALL,    /* wall forces and wall motion */
    TIMER_COMM,    /* values of copies sent, forces sent back */
    TIMER_DECIDE,  /* is a rebuild due? (waiting for other ranks included) */
    TIMER_MIGRATE, /* rebuild: particles change ranks */
    TIMER_REORDER, /* rebuild: particles sorted into cell order */
    TIMER_GHOSTS,  /* rebuild: copies made */
    TIMER_INDEX,   /* rebuild: the index built */
    TIMER_PAIRS,   /* rebuild: the pair list counted and filled */
    TIMER_HISTORY, /* rebuild: contact history carried over */
    TIMER_OUTPUT,  /* files, observables, progress */
    TIMER_OTHER,   /* time that no other stage covers */
    TIMER_STAGES
};

struct timers {
    double seconds[TIMER_STAGES]; /* exclusive time */
    uint64_t calls[TIMER_STAGES];
    int depth;
    enum timer_stage stack[16];
    double since; /* when the running stage began or resumed */
};

/* Seconds since an arbitrary fixed moment; monotonic. Any thread. */
double timer_now(void);

/* The stage of a name, TIMER_OTHER if there is none. */
enum timer_stage timer_stage_find(const char *name);

/* The name of a stage as it stands in report.json ("advance", "contact", ...). */
const char *timer_stage_name(enum timer_stage stage);

/* timer_start starts a stage inside the running one, whose clock pauses; timer_stop ends the stage. */
void timer_start(struct timers *timers, enum timer_stage stage);
void timer_stop(struct timers *timers, enum timer_stage stage);

#endif
