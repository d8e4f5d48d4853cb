/* SPDX-License-Identifier: BSD-3-Clause */
/* The files of a run: which are open, when they are due. */
#ifndef SCREE_ENGINE_OUTPUTS_H
#define SCREE_ENGINE_OUTPUTS_H

#include "engine/state.h"
#include "observe/observables.h"
#include "formats/output.h"

struct outputs;

/* What stays the same for the writers of a run. Borrows the simulation and the directory, which may be NULL
 * where nothing is written. */
struct output_run outputs_run(const struct simulation *simulation, const char *directory);

/* Checks what the scene asks for; writes nothing. `run` and its strings are borrowed until the end. Errors
 * (user) name the place in the scene. Collective. */
bool outputs_create(struct outputs **outputs, const struct simulation *simulation,
                    const struct output_run *run, struct error *error);

/* Opens the files in run->directory; on a resume goes on with those there. Collective. */
bool outputs_open(struct outputs *outputs, const struct simulation *simulation, bool resumed,
                  struct error *error);

/* Tells whether the step to come writes observables that need sums, so that its forces compute them. */
bool outputs_want_sums(const struct outputs *outputs, const struct simulation *simulation, uint64_t step);

/* True if dissipated energy or another sum over steps is observed. */
bool outputs_sum_each_step(const struct outputs *outputs);

/* True if outputs_write has anything to write now: what physics show then must be known (physics_look). */
bool outputs_due(const struct outputs *outputs, const struct simulation *simulation);

/* Writes what is due at the present step. Collective. */
bool outputs_write(struct outputs *outputs, const struct simulation *simulation, struct error *error);

/* Writes what waits for the next frame. Collective. */
bool outputs_flush(struct outputs *outputs, struct error *error);

/* Closes all files, with what waits for the next frame unless `error` is of kind ERROR_SYSTEM, and frees.
 * Collective. */
bool outputs_close(struct outputs **outputs, const struct comm *comm, struct error *error);

#endif
