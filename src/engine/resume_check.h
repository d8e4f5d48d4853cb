/* SPDX-License-Identifier: BSD-3-Clause */
/* Resuming with a changed scene: changes that can be applied are applied, other changes are refused. */
#ifndef SCREE_ENGINE_RESUME_CHECK_H
#define SCREE_ENGINE_RESUME_CHECK_H

#include "engine/state.h"
#include "data/formats/checkpoint.h"

/* Refuses (user) a checkpoint that does not fit the scene: another box, dimension, law, history of contacts
 * or system of units, or a scene without the material or group of a particle. Lists the changes in
 * simulation->resumed. The same on every rank. */
bool resume_check(struct simulation *simulation, const char *path, const struct checkpoint_loaded *loaded,
                  struct error *error);

/* Gives the particles of a checkpoint the numbers of their materials and groups in the scene, by name. Sets
 * the masses that follow from changed densities, and from motions that have become prescribed or free. A
 * particle whose density differs from that of the material keeps its own density. Returns the number of particles of all
 * ranks whose mass follows a changed density. Called after resume_check. Collective. */
uint64_t resume_apply(struct particles *particles, const struct scene *scene, const struct box *box,
                      const struct comm *comm, const struct checkpoint_loaded *loaded);

/* Prints the changes, a line a key. One rank. */
void resume_print(const struct resumed *resumed, uint64_t step, const char *path, FILE *out);

#endif
