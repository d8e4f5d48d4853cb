/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of simulation.c: the parts of a simulation beside its particles, and checks of the scene against them. */
#ifndef SCREE_ENGINE_SIMULATION_PARTS_H
#define SCREE_ENGINE_SIMULATION_PARTS_H

#include "engine/state.h"

/* Prepares threads, physics, domain and index. False with an error, which may differ between ranks. */
bool simulation_parts_prepare(struct simulation *simulation, struct error *error);

/* Makes all parts that do not depend on the number of particles. */
void simulation_parts_create(struct simulation *simulation);

/* Prints the progress of a long placement (`part` of it is done): a line of rank 0 every five seconds, if progress is
 * shown. `context` is the simulation. */
void simulation_parts_placed(void *context, const char *what, double part);

/* Refuses periodic edges that are too short for the present particles, or for particles of insertions: a cut-off
 * may reach neither to the particle itself, nor twice to another one. */
bool simulation_parts_box(const struct scene *scene, const struct box *box,
                          const struct size_classes *classes, struct error *error);

/* Refuses an index of the scene that cannot serve the present particles of this rank, of which `view` is. */
bool simulation_parts_index(const struct scene *scene, const struct index_view *view, struct error *error);

#endif
