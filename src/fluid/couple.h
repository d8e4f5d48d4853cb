/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains that the fluid moves (`fluid.grains: free`): force and torque of the fluid on each of them go into the motion of
 * the grain, whose boundary particles ride on it (ride.h). The fluid makes a step every `every` steps of the grains, of the
 * length dt_f = every dt; its load F, T, the momentum that it loses to the grain (forces.h), is held between its steps.
 *
 * The load answers to the acceleration a of the grain in the step of the fluid before, by -m_a a with the added mass m_a
 * and by the drag of that step: with such a force, a step late, a light grain would swing up. A virtual mass M on both
 * sides of Newton's law takes that away:
 *
 *   (m + M) a = F + f + m g - rho V g + V f_drive + M a_before,    M = rho V (C + nu dt_f (18 / d^2 + 4 / (d dx)))
 *
 * with the forces f of contacts, the displaced volume V, the diameter d, the mean acceleration a_before of the last step of
 * the fluid, and C = fluid.grains.virtual_mass. M cancels where the acceleration is steady; what is left is of first order
 * in dt_f. With the backward differences of path.h and an added mass A the acceleration follows (m + M) a'' = (M - 3/2 A) a'
 * + 1/2 A a, which decays for any m > 0 if M > A. A is rho V / 2 for a sphere, rho V for a disc, more near walls and with the
 * fluid that its surface drags along: C = 2 has room for discs without mass (with C = 1 one of them swung up). The second
 * part of M is that of Stokes's drag; the third one that of the pressure mu div u* of the projection, which in steps that are
 * long against the diffusion over a spacing dx answers to changes of the velocity of the surface (without it grains of 16
 * spacings swung up at nu dt_f = 13 dx^2). The forces at feet are those of the
 * velocity relative to the rigid motion of the grain (forces.h), so that their torque is the whole one: a stress of no strain has none. A virtual moment of
 * inertia rho V (C r^2 / 4 + 6 nu dt_f) does the same for the spin. rho V g is buoyancy, as the equations of the fluid have no gravity. In two dimensions forces and V are
 * those per depth; a grain's mass is what the scene gives. */
#ifndef SCREE_FLUID_COUPLE_H
#define SCREE_FLUID_COUPLE_H

#include "engine/physics.h"
#include "fluid/fluid.h"

/* True if the fluid moves grains. */
bool couple_free(const struct fluid_options *options);

/* True if the keys go together with the others; else a user's error with the key. */
bool couple_suits(const struct physics_context *context, struct error *error);

/* Steps of the grains in one of the fluid; true if the fluid makes one in this step of the grains; the length of its step. */
uint64_t couple_every(const struct physics_context *context);
bool couple_due(const struct physics_context *context);
double couple_dt(const struct physics_context *context);

/* After a step of the fluid: its load on the grains, and their mean acceleration since the step before. Collective. */
void couple_load(const struct physics_context *context);

/* Once in each step of the grains, when their contacts have been summed: the load, buoyancy and virtual mass change the
 * forces on the owned grains. */
void couple_apply(const struct physics_context *context);

#endif
