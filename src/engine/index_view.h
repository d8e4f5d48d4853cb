/* SPDX-License-Identifier: BSD-3-Clause */
/* Views of the state of a simulation. */
#ifndef SCREE_ENGINE_INDEX_VIEW_H
#define SCREE_ENGINE_INDEX_VIEW_H

#include "engine/state.h"

/* The view for output/. Borrows all members. */
struct output_view simulation_view(const struct simulation *simulation);

/* The view of a set of particles for an index. */
void simulation_index_view(struct simulation *simulation, struct index_view *view);

/* Sides of contacts in the last evaluation of forces, this rank's. */
int64_t simulation_contact_sides(const struct simulation *simulation);

/* True if a sphere at x (box-relative) would overlap an obstacle, such as a wall. Any thread. */
bool simulation_occupied(const struct simulation *simulation, const double x[3], double radius);

/* True if particles may leave through an open side and be deleted. */
bool simulation_may_lose(const struct simulation *simulation);

#endif
