/* SPDX-License-Identifier: BSD-3-Clause */
/* A flow (flow.h) on the fields of a set of particles. */
#ifndef SCREE_SCHEMES_FLOW_FIELDS_H
#define SCREE_SCHEMES_FLOW_FIELDS_H

#include "engine/physics.h"
#include "physics/fluid/schemes/flow.h"

/* Fills a flow with the present arrays of the particles; `flow->context` borrows the context. Again after each
 * rebuild. The fields are those of fluid_fields. */
void flow_fields_take(struct flow *flow, const struct physics_context *context, const struct weights *weights,
                      int regions);

/* Brings the copies of an array of the particles up to date. Collective. */
void flow_fields_forward(const struct physics_context *context, enum flow_array array);

/* The same for places and velocities of all particles. Collective. */
void flow_fields_forward_places(const struct physics_context *context);

#endif
