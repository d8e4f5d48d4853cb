/* SPDX-License-Identifier: BSD-3-Clause */
/* The passes of a fluid: one step of the flow, and what output wants of it. */
#ifndef SCREE_SCHEMES_FLUID_PASSES_H
#define SCREE_SCHEMES_FLUID_PASSES_H

#include "engine/physics.h"

/* After a rebuild: weights and mirrors; matrices are made again if the particles of any rank are others, or lie in
 * another order. Collective. */
void fluid_passes_rebuilt(const struct physics_context *context);

/* A step of the flow, once for each step of the clock; an error waits for the guard. Collective. */
void fluid_passes_step(const struct physics_context *context);

/* Before output: the divergence. Collective. */
void fluid_passes_look(const struct physics_context *context);

/* Half a spacing in a step at the largest speed; no limit without inertia, and 1 where the flow is
 * steady, as the time of its only step has no meaning. Collective. */
double fluid_passes_limit(const struct physics_context *context, double most);

/* Ends the linear algebra. Collective. */
void fluid_passes_end(void *self);

#endif
