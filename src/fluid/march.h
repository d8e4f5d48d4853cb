/* SPDX-License-Identifier: BSD-3-Clause */
/* The passes of a fluid: one step of the flow, and what output wants of it. */
#ifndef SCREE_FLUID_MARCH_H
#define SCREE_FLUID_MARCH_H

#include "engine/physics.h"

/* After a rebuild: weights and mirrors; matrices are made again if the particles of any rank are others, or lie in
 * another order. Collective. */
void march_rebuilt(const struct physics_context *context);

/* A step of the flow, once for each step of the clock; an error waits for the guard. Collective. */
void march_step(const struct physics_context *context);

/* Before output: the divergence. Collective. */
void march_look(const struct physics_context *context);

/* Half a spacing in a step at the largest speed; no limit without inertia, and 1 where the flow is
 * steady, as the time of its only step has no meaning. Collective. */
double march_limit(const struct physics_context *context, double most);

/* Ends the linear algebra. Collective. */
void march_end(void *self);

#endif
