/* SPDX-License-Identifier: BSD-3-Clause */
/* The files of a run: opens the files, and writes to each when it is due. */
#ifndef SCREE_ENGINE_OUTPUTS_H
#define SCREE_ENGINE_OUTPUTS_H

#include "engine/state.h"
#include "data/observe/observables.h"
#include "data/formats/output.h"

struct outputs;

/* The data that stay the same for the writers of a run. Borrows all but the box; the directory may be NULL if nothing is
 * written. */
struct output_run outputs_run(const struct scene *scene, const struct box *box, const struct lineage *lineage,
                              const char *directory);

/* Checks the outputs that the scene asks for; writes nothing. `run` and its strings are borrowed until the
 * end. Errors (user) name the place in the scene. Collective. */
bool outputs_create(struct outputs **outputs, const struct simulation *simulation,
                    const struct output_run *run, struct error *error);

/* True if a resumed run can go on with the files in its folder. Changes nothing. Collective. */
bool outputs_go_on(const struct outputs *outputs, const struct comm *comm, struct error *error);

/* Opens the files in run->directory, and the tables of the physics; a resume continues the existing files at the step of
 * the view. Collective. */
bool outputs_open(struct outputs *outputs, const struct output_view *view, const struct physics_set *set,
                  bool resumed, struct error *error);

/* Tells whether the step to come writes observables that need sums, so that its forces compute them. */
bool outputs_want_sums(const struct outputs *outputs, const struct clock *clock, uint64_t step);

/* The interval of a grid: its own, or that of the observables. */
const struct output_interval *outputs_grid_every(const struct output_options *options, int grid);

/* True if dissipated energy or another sum over steps is observed. */
bool outputs_sum_each_step(const struct outputs *outputs);

/* True if outputs_write has anything to write at this step, the present one or the next: the values that physics show must
 * then be computed (physics_look). */
bool outputs_due(const struct outputs *outputs, const struct clock *clock, uint64_t step);

/* Writes all outputs that are due at the present step, that of the view, and then the tables of the physics. Collective. */
bool outputs_write(struct outputs *outputs, const struct output_view *view, const struct physics_set *set,
                   const struct clock *clock, struct error *error);

/* Writes the rows that wait of the tables of physics. Collective. */
bool outputs_tables(const struct physics_set *set, const struct comm *comm, struct error *error);

/* Writes the data that wait for the next frame, and the tables. Collective. */
bool outputs_flush(struct outputs *outputs, const struct physics_set *set, const struct comm *comm,
                   struct error *error);

/* Writes the first observables of the last row as ", energy_kinetic 0.3 J, ..." to `text`; "" before the first
 * row. `outputs` is a struct outputs *, or NULL. */
void outputs_last_values(const void *outputs, char *text, size_t room);

/* Writes the data that wait for the next frame, unless `error` is of kind ERROR_SYSTEM, closes all files, and
 * frees. Collective. */
bool outputs_close(struct outputs **outputs, const struct comm *comm, struct error *error);

#endif
