/* SPDX-License-Identifier: BSD-3-Clause */
/* The force of the fluid on bodies: forces at feet (forces.h), summed by grain, by group or by wall. */
#ifndef SCREE_FLUID_DRAG_H
#define SCREE_FLUID_DRAG_H

#include "engine/physics.h"
#include "fluid/flow.h"
#include "fluid/forces.h"

/* (*grain)[foot] = the number of the grain, owned or a copy, on which a foot of the weights lies; SIZE_MAX: on none. Resizes
 * *grain, which memory_free releases. */
void drag_grains(size_t **grain, const struct particles *p, const struct weights *weights);

/* Finds the forces at all feet, to be released by forces_free, and fills the field `drag` of the owned grains; `viscosity` is dynamic.
 * Collective. */
void drag_look(struct forces *forces, const struct physics_context *context, const struct flow *flow,
               double viscosity);

#endif
