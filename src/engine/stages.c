/* SPDX-License-Identifier: BSD-3-Clause */
/* Registers the stages of a run in the order in which the report shows them. Read stages.h first. */
#include "engine/stages.h"
#include <assert.h>
#include <string.h>

/* The engine's own stages; those from LATER on come after the stages of physics. */
static const struct timer_stage own[] = {
    {.name = "setup", .help = "0: the time before the first step is in `seconds_setup`", .use = TIMER_START},
    {.name = "sweep", .help = "drift and particle forces in one pass", .use = TIMER_WORK},
    {.name = "comm", .help = "values of copies sent, forces sent back", .use = TIMER_WAIT},
    {.name = "decide",
     .help = "whether a rebuild is due, waiting for other ranks included",
     .use = TIMER_WAIT},
    {.name = "migrate", .help = "rebuild: particles change ranks", .use = TIMER_REBUILD | TIMER_WAIT},
    {.name = "reorder",
     .help = "rebuild: particles sorted into cell order",
     .use = TIMER_REBUILD | TIMER_WORK},
    {.name = "ghosts", .help = "rebuild: copies made", .use = TIMER_REBUILD | TIMER_WAIT},
    {.name = "index", .help = "rebuild: index", .use = TIMER_REBUILD | TIMER_WORK},
    {.name = "pairs", .help = "rebuild: pair list", .use = TIMER_REBUILD | TIMER_WORK},
    {.name = "history",
     .help = "rebuild: springs of contacts carried over",
     .use = TIMER_REBUILD | TIMER_WORK},
    {.name = "output", .help = "files, observables, progress"},
    {.name = "other", .help = "the rest"},
};
enum { OWN = sizeof own / sizeof own[0], SWEEP = 1, LATER = 2 };

static void own_register(struct timers *timers, int first, int end) {
    for (int k = first; k < end; k++)
        timer_register(timers, own[k].name, own[k].help, own[k].use);
}

static bool is_own(const char *name) {
    for (int k = 0; k < OWN; k++)
        if (strcmp(own[k].name, name) == 0)
            return true;
    return false;
}

static const char *name_of(const struct physics_pass *pass) {
    return pass->timer ? pass->timer : pass->name;
}

/* Registers the stages of the passes of one place of the step. Look passes belong to the output. */
static void physics_register(struct timers *timers, const struct physics *const *physics, int count,
                             enum pass_place place) {
    for (int k = 0; k < count; k++)
        for (int p = 0; p < physics[k]->passes; p++) {
            const struct physics_pass *pass = &physics[k]->pass[p];
            if (pass->place == place && !is_own(name_of(pass)))
                timer_register(timers, name_of(pass), pass->does ? pass->does : pass->name, TIMER_WORK);
        }
}

/* Registers what physics adds to the stages of passes. */
static void further_register(struct timers *timers, const struct physics *const *physics, int count) {
    for (int k = 0; k < count; k++)
        for (int p = 0; physics[k]->shown && p < physics[k]->shown->stages; p++) {
            const struct timer_stage *stage = &physics[k]->shown->stage[p];
            timer_register(timers, stage->name, stage->help, stage->use);
        }
}

int stages_begin(struct timers *timers) {
    own_register(timers, 0, SWEEP);
    return 0;
}

void stages_register(struct timers *timers, const struct physics *const *physics, int count) {
    static const enum pass_place then[] = {PASS_PAIRS, PASS_SHARES, PASS_MOVED, PASS_CLOSE, PASS_FIRST};
    own_register(timers, 0, SWEEP);
    physics_register(timers, physics, count, PASS_MOVE);
    own_register(timers, SWEEP, LATER);
    for (size_t k = 0; k < sizeof then / sizeof then[0]; k++)
        physics_register(timers, physics, count, then[k]);
    further_register(timers, physics, count);
    own_register(timers, LATER, OWN);
}

void stages_register_all(struct timers *timers) {
    const struct physics *physics[PHYSICS_ALL];
    for (int k = 0; k < PHYSICS_ALL; k++) /* those that are always there come first, as in a run */
        physics[k] = physics_get((enum physics_number)((k + PHYSICS_COUNT) % PHYSICS_ALL));
    stages_register(timers, physics, PHYSICS_ALL);
}

int stages_find(const struct timers *timers, const char *name) {
    int stage = timer_find(timers, name);
    assert(stage >= 0);
    return stage;
}

int stages_of_pass(const struct timers *timers, const struct physics_pass *pass) {
    return stages_find(timers, name_of(pass));
}
