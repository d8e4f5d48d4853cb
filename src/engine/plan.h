/* SPDX-License-Identifier: BSD-3-Clause */
/* The plan of a step: the passes of all active physics and of the engine itself, merged into one list that
 * runs from top to bottom and that `scree check` prints.
 *
 * Two orders are made from the same passes. The plain one runs pass after pass, place by place (physics.h).
 * In the fused one the passes by rows that move particles, and the passes by block that follow them, share
 * one visit to each block: the particles of a block move just before the first pair that reads them, while
 * the particles are in the cache (fused.h). A pass by block joins the visit if the pass walks over the
 * list of the sweep, which is the list of grains. Other passes run by themselves, after the copies have
 * arrived. Both orders give the same bits. */
#ifndef SCREE_ENGINE_PLAN_H
#define SCREE_ENGINE_PLAN_H

#include "base/timer.h"
#include "engine/physics_set.h"
#include <stdio.h>

enum { PLAN_PASSES_MAX = 32 };

struct simulation;

/* A pass of the engine's own. */
struct engine_pass {
    const char *name, *why; /* as in struct physics_pass */
    const char *timer;      /* its stage (stages.h) */
    unsigned needs;         /* what must hold for it to run; all that it names (enum engine_need) */
    void (*run)(struct simulation *simulation);
};

/* What a run has or has not. */
enum engine_need { NEED_RANKS = 1, NEED_REVERSE = 2, NEED_BOX_MOTION = 4, NEED_STRESS = 8, NEED_CALLER = 16 };

/* One entry: a pass of the engine's, or of a physics with its context. */
struct plan_pass {
    const char *name, *why;
    int timer; /* stage, registered */
    void (*run)(struct simulation *simulation);
    const struct physics_pass *pass;
    const struct physics_context *context; /* borrowed from the physics set */
    const struct pairlist *list;           /* whose blocks the pass visits; by rows: the list of the sweep */
    double (*speed)[CLASS_MAX];            /* by rows: of the set */
};

struct plan {
    int passes;
    struct plan_pass pass[PLAN_PASSES_MAX];
};

/* Passes that share a visit. */
struct plan_visit {
    int count;
    double (
        *speed)[CLASS_MAX]; /* [thread][class]: raised to the largest squared speed of what moves; borrowed */
    struct plan_pass pass[PLAN_PASSES_MAX];
};

/* The orders, and the passes of the visits of the fused one. */
struct step_plan {
    struct plan plain, fused;
    int forces;                     /* the first pass of the plain order at PASS_PAIRS */
    struct plan_visit moves, pairs; /* by rows; by block, on the list of the sweep */
};

/* The engine's own passes between those of the physics; lists end with a NULL run. */
struct engine_passes {
    const struct engine_pass
        *before[PASS_PLACES];        /* the passes of a place; of PASS_LOOK: at the end of a step */
    const struct engine_pass *renew; /* plain: before PASS_PAIRS */
    const struct engine_pass
        *sweep; /* fused: from the first move to the last sum over pairs of the sweep's list */
};

/* Makes the plan; once a run, before the first step, after the stages have been registered with
 * `timers`. `holds`: what the run has (enum engine_need). */
void plan_make(struct step_plan *plan, const struct physics_set *set, const struct engine_passes *engine,
               const struct timers *timers, unsigned holds);

/* Runs the passes from number `first` on, each under its timer. */
void plan_run(const struct plan *plan, int first, struct timers *timers, struct simulation *simulation);

/* plan_move moves the particles [first, last) of a class; plan_block computes one block of pairs. Many
 * threads at once. */
void plan_move(const struct plan_visit *moves, int thread, size_t first, size_t last, int size_class);
void plan_block(const struct plan_visit *pairs, int thread, int block);

/* All rows, and all blocks, by all threads; for tests of the plain order and for repeated evaluations. Both
 * functions open their own teams. */
void plan_move_all(const struct plan_visit *moves, const struct pairlist *list);
void plan_block_all(const struct plan_visit *pairs, const struct pairlist *list);

/* Discards the results of the blocks of this step. */
void plan_abandon(const struct plan_visit *pairs);

/* Prints a line for each pass: name, reason, fields read and written. */
void plan_print(const struct plan *plan, FILE *file);

/* Prints the names of the passes of the visits, in one line: "advance, contact". */
void plan_print_visits(const struct step_plan *plan, FILE *file);

#endif
