/* SPDX-License-Identifier: BSD-3-Clause */
/* Going on from a checkpoint: what of a changed scene can be applied is, what cannot is refused. */
#ifndef SCREE_ENGINE_RESUME_CHECK_H
#define SCREE_ENGINE_RESUME_CHECK_H

#include "engine/state.h"
#include "formats/checkpoint.h"

/* Refuses (user) a checkpoint that the scene cannot go on from: another box, dimension, law, history of
 * contacts or system of units, or without a material or group that particles are of. Lists in
 * simulation->resumed what has changed. The same on every rank. */
bool resume_check(struct simulation *simulation, const char *path, const struct checkpoint_loaded *loaded,
                  struct error *error);

/* Gives the particles read from a checkpoint the numbers that their materials and groups have in the scene,
 * by name, and the masses that follow from densities that have changed and from motions that are prescribed
 * now and were not, or the other way round. A particle whose density is its own keeps it. resume_check has
 * gone before. Collective. */
void resume_apply(struct simulation *simulation, const struct checkpoint_loaded *loaded);

/* Prints what has changed, a line a key. One rank. */
void resume_print(const struct simulation *simulation, const char *path, FILE *out);

#endif
