/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains that the fluid does not resolve: those up to the radius fluid.grains.unresolved. They are no boundary of the fluid; the
 * physics `drag` gives each a force F by its law (physics/drag/drag.h), and the fluid loses what it gains, by shares
 *
 *   s_ij = W(|x_i - x_j|) / sum over j of W
 *
 * of the fluid particles j within the support of the fluid's kernel W around grain i, so that no momentum is lost. The velocity w of the fluid
 * has no divergence: it is the volume flow of fluid and grains together, w = e u + q with the porosity e, the velocity u of the fluid and the
 * volume flow q of the grains,
 *
 *   (1 - e)_j = sum over i of s_ij V_i / V_j,   q_j = sum over i of s_ij V_i v_i / V_j,
 *
 * so that the room that grains take is in the equation of continuity, and w - v = e (u - v) is the superficial slip of the laws.
 *
 * Where the particles of the fluid rest, its equations are those of the volume average (set I of Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661 (2010) 482, which is
 * their set II, "model A", written otherwise):
 *
 *   rho d(e u)/dt + rho div (e u u) = -grad p + f + mu div grad w - sum over i of s_ij F_i / V_j
 *   F_i = e_i K (w_i - v_i) - V_i (grad p - f)_i,   e_i, w_i, grad p_i = sum over j of s_ij (e_j, w_j, grad p_j)
 *
 * with the law's K in form B (drag_law.h), of which e K is that of form A; f drives the fluid. A bed at rest loses the pressure sum of K w: what the law says.
 *
 * Each step of the fluid, every n steps of the grains, (1) takes the impulse that the forces on grains have had since the last one, (2) solves
 * with drag and pressure on grains at its end, in place of those that it gave before: with a = dt sum s_ij e_i K_i / (rho V_j),
 *
 *   w* = w^n + (w without that - w^n) / (1 + a),   w^(n+1) = w* - dt / rho k grad phi,   k = e / (1 + a)      (projection.h)
 *
 * where a fluid particle has the drag of its own w, sum over i of s_ij e_i K_i (w_j - v_i), which adds up to that of the grains and lets no flow alternate
 * from particle to particle, (3) gives each grain what this differs by, dt (e K (w^(n+1) - w^n) - V grad phi), as a jump of its velocity, and (4) what it sees until the next
 * one. So the sum of all momenta is kept to rounding, and no step is too long for drag.
 *
 * Elsewhere grains are taken to be few: F = K (w - v), the inertia of the fluid is that of a fluid without grains, and what grains give acts in the
 * next step of the fluid. */
#ifndef SCREE_COUPLING_UNRESOLVED_GRAINS_H
#define SCREE_COUPLING_UNRESOLVED_GRAINS_H

#include "engine/physics.h"
#include "physics/fluid/fluid.h"

/* True if there are such grains; true if a grain of this radius is one. Any thread. */
bool unresolved_any(const struct fluid_options *options);
bool unresolved_is(const struct fluid_options *options, double radius);

/* True if the equations are those of the volume average. */
bool unresolved_averaged(const struct fluid_options *options);

/* True if the keys go together with the others; else a user's error with the key. */
bool unresolved_suits(const struct physics_context *context, struct error *error);

/* Registers the fields of the exchange (physics/drag/carrier.h), and the fluid's own. */
void unresolved_fields_add(const struct fluid_options *options, struct particles *particles);

/* What grains see at the start. An error on all ranks if a grain has no fluid around it. Opens its own team, as all that follow. Collective. */
void unresolved_begin(const struct physics_context *context);

/* Once in each step of the grains: their forces become impulses that the fluid has to lose. */
void unresolved_give(const struct physics_context *context);

/* Before a step of the fluid, of the length dt: flow->body, resist and mobility. An error if grains leave the fluid, fill it, or, where they act in its next step,
 * take all its momentum within dt. Collective. */
void unresolved_act(const struct physics_context *context, double dt);

/* After it: the jumps of grains, and what they see. Collective. */
void unresolved_look(const struct physics_context *context, double dt);

/* The momentum of the fluid of this rank per density, less that of the room that grains take. */
void unresolved_flow(const struct particles *particles, size_t i, double flow[3]);

#endif
