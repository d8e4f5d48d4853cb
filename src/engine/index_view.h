/* SPDX-License-Identifier: BSD-3-Clause */
/* Views of the state of a simulation. */
#ifndef SCREE_ENGINE_INDEX_VIEW_H
#define SCREE_ENGINE_INDEX_VIEW_H

#include "engine/state.h"

/* The view for output/. Borrows all members. */
struct output_view simulation_view(const struct simulation *simulation);

/* The view of a set of particles for an index. */
void simulation_index_view(struct simulation *simulation, struct index_view *view);

#endif
