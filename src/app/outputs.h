/* The files of a run: which are open, when they are due. */
#ifndef SCREE_APP_OUTPUTS_H
#define SCREE_APP_OUTPUTS_H

#include "app/simulation.h"
#include "output/observables.h"
#include "output/output.h"

struct outputs;

/* Opens what the scene asks for, in run->directory; on a resume goes on with the files there. `run` and its
 * strings are borrowed until the end. Collective. */
bool outputs_open(struct outputs **outputs, const struct simulation *simulation, const struct output_run *run,
                  bool resumed, struct error *error);

/* Tells whether the step to come writes observables that need sums, so that its forces compute them. */
bool outputs_want_sums(const struct outputs *outputs, const struct simulation *simulation, uint64_t step);

/* True if dissipated energy or another sum over steps is observed. */
bool outputs_sum_each_step(const struct outputs *outputs);

/* Writes what is due at the present step. Collective. */
bool outputs_write(struct outputs *outputs, const struct simulation *simulation, struct error *error);

/* The observables, NULL if none. */
const struct observables *outputs_observables(const struct outputs *outputs);

/* Closes all files and frees. Collective. */
bool outputs_close(struct outputs **outputs, const struct comm *comm, struct error *error);

#endif
