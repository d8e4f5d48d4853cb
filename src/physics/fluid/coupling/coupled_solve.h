/* SPDX-License-Identifier: BSD-3-Clause */
/* A step of the fluid and the velocities of the grains that it moves, found together. The grains come from their own steps (grain_coupling.h) with
 * velocities U*, for which the load F0 of the step before was held. What the fluid does in its step depends on their velocities U,
 * and its load F(U) in turn changes these:
 *
 *     m (U - U*) = dt (F(U) - F0),     the same for spins, with moments of inertia and torques
 *
 * F is affine in U, with an added mass and a drag that are not known, and in a gap between grains as large as one likes. So the
 * equations are solved by generalised conjugate residuals over the velocities and spins of all grains, as the map is not symmetric in narrow gaps: one try of the step (moving_step_try) an iteration and
 * one at the end, with m + A + rho V nu dt (18 / d^2 + 4 / (d dx)) as preconditioner, A the added mass of a grain alone, I + 6 rho V nu dt for spins.
 *   Contacts act before, in the steps of the grains, with the mass m alone; then the pressure takes out of grains and fluid what is not free of divergence,
 * as a projection does, which feeds no energy to grains that rest on each other. (A load taken a step late, with a virtual mass M that acts on changes of the acceleration,
 * gives a contact of the frequency w its acceleration of the step before: a damping of -M dt w^2, and grains that touch swing up whatever M.)
 * What is held, F0, may still feed motions of contacts that have no damping, where w dt is near 5. */
#ifndef SCREE_COUPLING_COUPLED_SOLVE_H
#define SCREE_COUPLING_COUPLED_SOLVE_H

#include "engine/physics.h"
#include "physics/fluid/schemes/moving_step.h"

/* Makes the step that `path` has begun: velocity and pressure of the fluid, the loads (grain_load), velocities and spins of the grains,
 * whose changes are then in fluid->jump. False with an error (ERROR_PHYSICS) if a solver failed. Collective. */
bool coupled_step(const struct physics_context *context, const struct path *path, struct error *error);

#endif
