/* SPDX-License-Identifier: BSD-3-Clause */
/* Boundary particles ride on grains that move: each keeps its place in the grain, the arm from the grain's centre, which
 * turns with the grain's spin, and has the velocity of the grain there. They move in the steps of the fluid: in a drift each goes where its own velocity
 * leads; then, when the copies of the grains have arrived, it takes its exact place, before a rebuild sorts the particles: a resume from a checkpoint, which
 * has places after all moves, then sorts into the same order. */
#ifndef SCREE_COUPLING_BOUNDARY_MOTION_H
#define SCREE_COUPLING_BOUNDARY_MOTION_H

#include "engine/physics.h"
#include "physics/fluid/fluid_state.h"

/* True if there may be grains that move in the fluid. */
bool boundary_wanted(const struct physics_context *context);

/* The drift of boundary particles: as `rows` of struct physics_pass, for [first, last) of a class of them. */
double boundary_move(const struct physics_context *context, size_t first, size_t last);

/* In a step of the fluid gives the boundary particles of grains their places, velocities and spins, in the copies too. In any step a particle that has no arm
 * yet gets it. Returns the number of this rank's particles whose grain was not found. Collective. */
size_t boundary_settle(const struct physics_context *context, const struct fluid *fluid);

/* After the drift of a step of the fluid, with the lists of the last rebuild: boundary_settle at the places of the grains now, those of copies too. In the fused
 * order, in which steps far from a rebuild go, this pass stands before the drift, and does nothing: the particles take their places with the weights of the
 * step. As `whole` of struct physics_pass. Collective. */
void boundary_follow(const struct physics_context *context);

#endif
