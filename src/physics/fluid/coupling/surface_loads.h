/* SPDX-License-Identifier: BSD-3-Clause */
/* The force of the fluid on bodies: forces at feet (surface_forces.h), summed by grain, by group or by wall. */
#ifndef SCREE_COUPLING_SURFACE_LOADS_H
#define SCREE_COUPLING_SURFACE_LOADS_H

#include "engine/physics.h"
#include "physics/fluid/schemes/flow.h"
#include "physics/fluid/operators/surface_forces.h"

/* (*grain)[foot] = the number of the grain, owned or a copy, on which a foot of the weights lies; SIZE_MAX: on none. Resizes
 * *grain, which memory_free releases. */
void surface_loads_grains(size_t **grain, const struct particles *p, const struct weights *weights);

/* Finds the forces at all feet, to be released by surface_forces_free, and fills the field `drag` of the owned grains; `viscosity` is dynamic.
 * Collective. */
void surface_loads_look(struct forces *forces, const struct physics_context *context, const struct flow *flow,
                        double viscosity);

#endif
