/* SPDX-License-Identifier: BSD-3-Clause */
/* The grains' own steps between those of a fluid that makes them rigid (rigid_step.h). Contacts act with the bare mass M of the grain, beside its weight less buoyancy and a
 * load of the fluid, force and torque. Of these steps places and the momentum of the contacts stay: by this, and by weight less buoyancy, the step of the fluid finds the
 * velocities from those of its step before.
 *
 * The load is the mean of those of the last steps of the fluid, each later one with the part RIGID_LOAD: H -> H + RIGID_LOAD (L - H), L = M dU/dt less contacts, weight and buoyancy. A grain
 * that creeps against drag, or that contacts hold against a flow, has L = H constant, and places agree with the velocities of the fluid. Without H a grain that touches moves too fast by dt L / (2 M), and the
 * fluid in one that is held moves by dt L / M. L alone has in it the answer to the last blow: with an added mass A of the fluid a grain that contacts stop in each step, and throw back with the restitution e, swings up where
 * w e > (1 + e) M / (M + A), w the part of the last load. Grains at rest have e = 0, as their bounces are over within a step.
 *
 * Before its first step of the fluid H is 0 of a grain that something touches, and holds the weight less buoyancy of one that nothing touches.
 *
 * The momentum of the contacts is by the trapezoidal rule, as the velocities that the grains store are those of half a step before. A solver
 * of contacts (physics/hard) finds its forces after the step of the fluid, from the velocities that this gave: they act for whole steps, and the velocities that the fluid
 * finds are those that grains store. */
#ifndef SCREE_COUPLING_RIGID_MOTION_H
#define SCREE_COUPLING_RIGID_MOTION_H

#include "engine/physics.h"

/* The part of the last load in the load that grains have in their own steps. */
#define RIGID_LOAD 0.3

/* When the contacts of a step of the grains have been summed, before the step of the fluid: adds to the momentum of each. */
void rigid_motion_gather(const struct physics_context *context);

/* The same with a solver of contacts: at the start of the next step, when it has given its forces. The first step of a run has half of them. */
bool rigid_motion_solved(const struct physics_context *context);
void rigid_motion_gather_solved(const struct physics_context *context);

/* After a step of the fluid: the grains get the velocities that it found; the changes are in fluid->jump. */
void rigid_motion_set(const struct physics_context *context);

/* In each step of the grains, after those two: adds buoyancy and the load of the fluid to the force of contacts. */
void rigid_motion_apply(const struct physics_context *context);

#endif
