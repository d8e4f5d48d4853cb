/* SPDX-License-Identifier: BSD-3-Clause */
/* The life of a run: from a scene to its files. */
#ifndef SCREE_ENGINE_RUN_H
#define SCREE_ENGINE_RUN_H

#include "engine/run_stages.h"
#include "engine/simulation.h"
#include "data/observe/progress.h"
#include "data/observe/report.h"

/* An observer of a running scene (functions may be NULL). All calls are collective. */
struct run_watch {
    void *context;
    /* Called before the first step, when particles, pairs and forces exist. May request sums at each step. */
    bool (*begin)(void *context, struct simulation *simulation, struct error *error);
    /* True if the observer wants the state after step number `step`. */
    bool (*due)(const void *context, uint64_t step);
    /* Gets the state after a step that was due. */
    bool (*look)(void *context, const struct simulation *simulation, struct error *error);
    bool without_sums; /* look needs no sums of forces (energies, stress) */
};

struct run_options {
    const char *directory;                /* NULL: no files at all (ablate) */
    const struct run_watch *watch;        /* borrowed; NULL: no observer */
    const char *resume;                   /* a checkpoint, or NULL */
    bool overwrite;                       /* an existing directory is used, and its files are replaced */
    bool quiet;                           /* neither notes, progress nor report on the terminal */
    const struct progress_series *series; /* borrowed, or NULL; if set, progress is shown although quiet */
};

/* Runs a scene to its end, stage by stage (run_chain.c). Fills `report` if it is not NULL (the caller calls report_destroy). Returns the
 * status of the program: 0, or the kind of the error; ERROR_SIGNAL + number, without an error, if a signal
 * ended the run after a checkpoint. A signal that comes between two runs ends the second run. Collective. */
int run_scene(const struct comm *comm, const struct scene *scene, const struct run_options *options,
              struct report *report, struct error *error);

/* As run_scene, for a run without stages (`chain` NULL) or one stage, which `chain` names; takes its end. */
int run_one(const struct comm *comm, const struct scene *scene, const struct run_options *options,
            struct run_chain *chain, struct report *report, struct error *error);

/* run_last_step: the number of the last step of a run. run_signals_catch: installs the signal handlers of a
 * run. run_signalled: the signal that this rank received, or 0. */
uint64_t run_last_step(const struct scene *scene, const struct stage_place *stage, const struct clock *clock);
void run_signals_catch(void);
int run_signalled(void);

/* Checks the directory before any file is made. Collective. */
bool run_directory_suits(const struct comm *comm, const struct run_options *options, struct error *error);

/* Prepares the directory: makes a missing one; exit 2 if the directory exists and is neither overwritten nor
 * resumed in. Collective. */
bool run_directory(const struct comm *comm, const struct run_options *options, struct error *error);

#endif
