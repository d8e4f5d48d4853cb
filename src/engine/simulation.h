/* SPDX-License-Identifier: BSD-3-Clause */
/* The life of a simulation:
 *
 *     simulation_create   scene -> law, walls, particles, domain, index; first rebuild, first forces. Law and walls are made by
 *                         grains_start (physics/grains/start.c), which the table of physics calls (physics_begin)
 *     step_run            one time step (step.h); runs call it through checked_step (checked.h)
 *     rebuild_run         migrate, reorder, ghosts, index, pairs (rebuild.h), when step_run finds it due
 *     simulation_destroy */
#ifndef SCREE_ENGINE_SIMULATION_H
#define SCREE_ENGINE_SIMULATION_H

#include "engine/state.h"

/* Builds all parts from a scene and, unless resuming, the particles of its sources; checks the time step.
 * `resume` (NULL: none) names a checkpoint to go on from. The caller owns comm and scene and keeps them.
 * Errors may differ between ranks: comm_agree follows inside. Collective. Returns NULL with the same error on
 * all ranks. */
struct simulation *simulation_create(const struct comm *comm, const struct scene *scene, const char *resume,
                                     struct error *error);

/* The same for another program than scree's own; `caller` is copied. The force of the caller is there from the
 * first forces on. Collective. */
struct simulation *simulation_create_for(const struct simulation_caller *caller, const struct comm *comm,
                                         const struct scene *scene, const char *resume, struct error *error);
void simulation_destroy(struct simulation **simulation);

#endif
