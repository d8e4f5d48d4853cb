/* SPDX-License-Identifier: BSD-3-Clause */
/* The life of a run: from a scene to its files. */
#ifndef SCREE_ENGINE_RUN_H
#define SCREE_ENGINE_RUN_H

#include "engine/simulation.h"
#include "observe/progress.h"
#include "observe/report.h"

/* Somebody who looks on while a scene runs (NULL where not needed). All calls are collective. */
struct run_watch {
    void *context;
    /* Before the first step, when particles, pairs and forces are there. May ask for sums at each step. */
    bool (*begin)(void *context, struct simulation *simulation, struct error *error);
    /* True if the state after step number `step` is to be looked at. */
    bool (*due)(const void *context, uint64_t step);
    /* Looks at the state after a step that was due. */
    bool (*look)(void *context, const struct simulation *simulation, struct error *error);
};

struct run_options {
    const char *directory;                /* NULL: no files at all (ablate) */
    const struct run_watch *watch;        /* borrowed; NULL: nobody looks on */
    const char *resume;                   /* a checkpoint, or NULL */
    bool overwrite;                       /* a directory that exists is used, its files replaced */
    bool quiet;                           /* neither notes, progress nor report on the terminal */
    const struct progress_series *series; /* borrowed; with it, progress is shown although quiet; or NULL */
};

/* Runs a scene to its end. Fills `report` where it is not NULL (report_destroy is the caller's). Returns the
 * status of the program: 0, or the kind of the error; ERROR_SIGNAL + number, without an error, where a signal
 * ended the run after a checkpoint. A signal that comes between two runs ends the second. Collective. */
int run_scene(const struct comm *comm, const struct scene *scene, const struct run_options *options,
              struct report *report, struct error *error);

/* The number of the last step of a run, and what takes signals for one. run_signalled: the signal that came
 * to this rank, or 0. */
uint64_t run_last_step(const struct simulation *simulation);
void run_signals_catch(void);
int run_signalled(void);

/* Prepares the directory: made if missing; exit 2 if it exists and is neither overwritten nor resumed in.
 * Collective. */
bool run_directory(const struct comm *comm, const struct run_options *options, struct error *error);

#endif
