/* SPDX-License-Identifier: BSD-3-Clause */
/* The force of the fluid on each grain: forces at feet (forces.h), summed over the ranks that hold copies. */
#ifndef SCREE_FLUID_DRAG_H
#define SCREE_FLUID_DRAG_H

#include "engine/physics.h"
#include "fluid/flow.h"

/* Fills the field `drag` of the owned grains; `viscosity` is dynamic. Collective. */
void drag_on_grains(const struct physics_context *context, const struct flow *flow, double viscosity);

#endif
