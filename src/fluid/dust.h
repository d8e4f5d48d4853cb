/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains that the fluid does not resolve: those up to the radius fluid.grains.unresolved. They are no boundary of the fluid; the
 * physics `drag` gives each a force F = K (u - v) by its law (drag/drag.h), and the fluid loses what it gains:
 *
 *   u = sum over j of s_j u_j,   force/volume on fluid particle j: -s_j F / V_j,   s_j = W(|x - x_j|) / sum of W
 *
 * over the fluid particles j within the support of the fluid's kernel W, so that no momentum is lost. The velocity u has no
 * divergence: it is the volume flow of fluid and grains together, e u_f + (1 - e) v with the porosity e, so that the room
 * that grains take is in the equation of continuity, and u - v = e (u_f - v) is the superficial slip of the laws. The inertia
 * of the fluid is that of a fluid without grains.
 *
 * The step of the fluid gets the impulse of the forces since its last step; each force acts from half a step of the grains
 * before to half a step after, so that momenta at full steps balance. */
#ifndef SCREE_FLUID_DUST_H
#define SCREE_FLUID_DUST_H

#include "engine/physics.h"
#include "fluid/fluid.h"

/* True if there are such grains; true if a grain of this radius is one. Any thread. */
bool dust_any(const struct fluid_options *options);
bool dust_is(const struct fluid_options *options, double radius);

/* True if the keys go together with the others; else a user's error with the key. */
bool dust_suits(const struct physics_context *context, struct error *error);

/* Registers the fields of the exchange (drag/carrier.h), and the fluid's own. */
void dust_fields_add(struct particles *particles);

/* As `needed` of a pass. */
bool dust_needed(const struct physics_context *context);

/* Fills carrier_seen; an error on all ranks if a grain has no fluid around it. Opens its own team. Collective. */
void dust_look(const struct physics_context *context);

/* Once in each step of the grains: their forces become impulses of the fluid. An error if a step of the fluid, of the length dt, is too long
 * for the exchange. Collective. */
void dust_give(const struct physics_context *context, double dt);

/* Before a step of the fluid, of the length dt: flow->body is what the grains have given since the last one. */
void dust_act(const struct physics_context *context, double dt);

#endif
