/* SPDX-License-Identifier: BSD-3-Clause */
/* The grains' own steps between those of a fluid that makes them rigid (rigid_step.h). Contacts act with the bare mass of the grain, and no load of the
 * fluid is held: it would have the answer to the last blow in it, and grains that rest would rattle. A grain that nothing touches keeps the velocity that
 * the fluid gave it; one that something touches has its weight less buoyancy. Of these steps places and the momentum of the contacts stay: by this, and by weight less
 * buoyancy, the step of the fluid finds the velocities from those of its step before.
 *
 * The momentum of the contacts is by the trapezoidal rule, as the velocities that the grains store are those of half a step before. A solver
 * of contacts (physics/hard) finds its forces after the step of the fluid, from the velocities that this gave: they act for whole steps, the velocities that the fluid
 * finds are those that grains store, and what touches a grain is known from the step before. */
#ifndef SCREE_COUPLING_RIGID_MOTION_H
#define SCREE_COUPLING_RIGID_MOTION_H

#include "engine/physics.h"

/* When the contacts of a step of the grains have been summed, before the step of the fluid: adds to the momentum of each. */
void rigid_motion_gather(const struct physics_context *context);

/* The same with a solver of contacts: at the start of the next step, when it has given its forces. The first step of a run has half of them. */
bool rigid_motion_solved(const struct physics_context *context);
void rigid_motion_gather_solved(const struct physics_context *context);

/* After a step of the fluid: the grains get the velocities that it found; the changes are in fluid->jump. */
void rigid_motion_set(const struct physics_context *context);

/* In each step of the grains, after those two: adds weight and buoyancy to the force of contacts. */
void rigid_motion_apply(const struct physics_context *context);

#endif
