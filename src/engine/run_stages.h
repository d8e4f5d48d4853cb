/* SPDX-License-Identifier: BSD-3-Clause */
/* The stages of a run (data/scene/scene_stage.h). Each stage is a simulation of its own: at its end the simulation writes a
 * checkpoint, and the simulation of the next stage, whose scene has changed, begins with this checkpoint. A resume does
 * the same, so that a run that was interrupted within a stage, or between two stages, has the same bits as a run that
 * was not. */
#ifndef SCREE_ENGINE_RUN_STAGES_H
#define SCREE_ENGINE_RUN_STAGES_H

#include "engine/state.h"
#include "data/observe/observables.h"

/* The end of the present stage; all zero: the scene has no stages. */
struct run_stages {
    const struct scene_stage *stage; /* borrowed from the scene; NULL: none */
    uint64_t first;                  /* the step before its first step in this program */
    int conditions;
    struct observables *condition[STAGE_CONDITIONS_MAX];
    bool met; /* the conditions have ended the stage */
};

/* A stage that this program has run, wholly or in part. */
struct run_stage {
    char name[OUTPUT_NAME_MAX];
    uint64_t first, last; /* numbers of the steps before and at the end */
    double time;          /* simulated time at the end */
    double seconds;       /* wall clock without set-up */
    const char *end;      /* why it ended; a literal */
};

/* The stages that this program has run. */
struct run_chain {
    int first;     /* number of the first of them */
    int number;    /* of the present one */
    uint64_t step; /* at its end */
    bool over;     /* the present stage has come to its end, and wrote its checkpoint */
    int done;
    struct run_stage row[STAGES_MAX];
};

/* Prepares the conditions of the present stage, whose first step follows that of the view. Fails (user) if an observable has
 * not exactly one column. */
bool run_stages_open(struct run_stages *stages, const struct scene *scene, const struct stage_place *place,
                     const struct output_view *view, const struct output_run *run, struct error *error);
void run_stages_close(struct run_stages *stages);

/* True if the conditions are looked at after step number `step`. */
bool run_stages_due(const struct run_stages *stages, const struct stage_place *place, uint64_t step);

/* True if a condition needs the sums of the forces in the step that is looked at; if it needs those of each step. */
bool run_stages_need_sums(const struct run_stages *stages);
bool run_stages_need_work(const struct run_stages *stages);

/* Looks at the conditions; if all hold, the next step is the last of the stage. Collective; all ranks decide alike. */
void run_stages_look(struct run_stages *stages, const struct output_view *view, struct stage_place *place,
                     struct error *error);

/* The number of the last step by the duration of the present stage, or by its conditions; `most` at most. */
uint64_t run_stages_last(const struct scene *scene, const struct stage_place *place,
                         const struct clock *clock, uint64_t most);

/* Ends the present stage before its last checkpoint: the state then belongs to the beginning of the next stage. */
void run_stages_end(struct stage_place *place, const struct clock *clock);

/* Adds the stage that has ended, or was broken off, to those that have been run; it took `seconds`. */
void run_stages_add(const struct run_stages *stages, const struct clock *clock, struct run_chain *chain,
                    double seconds);

/* Finds the stage with which a run begins: that of the checkpoint `resume`, or 0 (NULL). The number of stages: all are
 * over. Fails (user) if the scene has fewer stages. Collective. */
bool run_stages_first(const struct comm *comm, const struct scene *scene, const char *resume, int *first,
                      struct error *error);

/* Writes the line that says which stage begins. */
enum { RUN_STAGES_TITLE_MAX = 160 };
void run_stages_title(const struct scene *scene, const struct stage_place *place, const struct clock *clock,
                      char *text, size_t size);

#endif
