/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of a simulation of the library. Read scree.h first. */
#ifndef SCREE_LIBRARY_SCREE_PARTS_H
#define SCREE_LIBRARY_SCREE_PARTS_H

#include "engine/run.h"
#include "engine/run_record.h"
#include "engine/run_stages.h"
#include "engine/state.h"
#include "base/file.h"
#include "data/observe/observables.h"
#include "scree.h"

struct scree_simulation {
    struct comm comm;
    struct scene *scene;
    struct simulation *state;
    struct error error; /* of the engine: no steps after it */
    void (*force)(void *context, struct scree_simulation *simulation);
    void *force_context;
    void (*log)(void *context, const char *line);
    void *log_context;
    struct output_run run;
    struct observables *observables;
    int columns;  /* of the observables; all stages have the same */
    bool changed; /* the next step rebuilds */
    bool busy;    /* a function of the library is at work, and may call those of the caller */
    double *row;  /* recorded rows, one after another */
    size_t rows, room;
    struct run_stages stages;
    struct scene *before;       /* of the stage that ends, while the next one begins */
    double *kept;               /* observables at the end of a stage, until the next step; NULL: none */
    struct run_record record;   /* of the steps so far, for the report */
    double spent, since;        /* seconds in these steps; clock at the start of the present one */
    char *report;               /* the last one that was asked for; NULL: none */
    char folder[FILE_PATH_MAX]; /* of the checkpoints between stages; "": they are deleted */
};

/* True if there is a simulation, and the call does not come from a function that the simulation itself has called; else false
 * with an error (user). */
bool scree_parts_free(const struct scree_simulation *simulation, struct error *error);

/* Copies an error to the caller's, if there is one. True if there is no error. */
bool scree_parts_tell(const struct error *own, struct scree_error *error);

/* Starts a part of the work on the simulation's threads, which is then busy; returns the caller's number of threads, which
 * scree_parts_leave sets back. `simulation` NULL: it is gone. */
int scree_parts_enter(struct scree_simulation *simulation);
void scree_parts_leave(struct scree_simulation *simulation, int threads);

/* The rows of observables of a simulation of the library. */

/* Makes the columns, and the first row of a simulation that is not resumed. Collective. */
bool scree_observe_begin(struct scree_simulation *simulation, bool resumed, struct error *error);

/* Frees the columns; the rows stay. */
void scree_observe_end(struct scree_simulation *simulation);

/* Keeps the observables of this moment, which scree_observe then tells until scree_observe_drop. Collective. */
bool scree_observe_keep(struct scree_simulation *simulation, struct error *error);
void scree_observe_drop(struct scree_simulation *simulation);

/* True if a row is due after step `number`, which ends at `time`. */
bool scree_observe_due(const struct scree_simulation *simulation, uint64_t number, double time);

/* Records a row of this moment. Collective. */
bool scree_observe_record(struct scree_simulation *simulation, struct error *error);

/* The report of a simulation of the library. */

/* Begins the record of steps for the report, after the simulation, or that of a stage, is made; this began at `began`. */
void scree_report_begin(struct scree_simulation *simulation, double began);

/* The stages of a scene in a simulation of the library (engine/run_stages.h). */

/* Takes the scene of the stage with which the simulation begins: that of the checkpoint `resume`, or the first (NULL).
 * Does nothing without stages. Fails (user) if all stages are over. Collective. */
bool scree_stages_first(struct scree_simulation *simulation, const char *resume, struct error *error);

/* Prepares the conditions of the present stage, and tells the caller which stage it is. */
bool scree_stages_begin(struct scree_simulation *simulation, struct error *error);

/* True if the conditions are looked at after step `number`, and need the sums of its forces. */
bool scree_stages_want_sums(const struct scree_simulation *simulation, uint64_t number);

/* True if step `number` is the last of the present stage, as far as is known; it must rebuild. */
bool scree_stages_last(const struct scree_simulation *simulation, uint64_t number);

/* Looks at the conditions after a step. If the step was the last of its stage, the simulation of the next stage takes
 * the place of the present one. Collective. */
bool scree_stages_advance(struct scree_simulation *simulation, struct error *error);

/* True if the last stage has ended. */
bool scree_stages_over(const struct scree_simulation *simulation);

#endif
