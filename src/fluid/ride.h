/* SPDX-License-Identifier: BSD-3-Clause */
/* Boundary particles ride on grains that move: each keeps its place in the grain, the arm from the grain's centre, which
 * turns with the grain's spin, and has the velocity of the grain there. In a drift it goes where its own velocity leads;
 * then, when the copies of the grains have arrived, it takes its exact place. */
#ifndef SCREE_FLUID_RIDE_H
#define SCREE_FLUID_RIDE_H

#include "engine/physics.h"
#include "fluid/state.h"

/* True if there may be grains that move in the fluid. */
bool ride_wanted(const struct physics_context *context);

/* The drift of boundary particles: as `rows` of struct physics_pass, for a class of them. */
void ride_move(const struct physics_context *context, int thread, size_t first, size_t last, int size_class);

/* Gives the boundary particles of grains their places, velocities and spins, in the copies too. A particle that has no arm
 * yet gets it. Returns the number of this rank's particles whose grain was not found. Collective. */
size_t ride_settle(const struct physics_context *context, const struct fluid *fluid);

#endif
