/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of heat. */
#ifndef SCREE_HEAT_FIELDS_H
#define SCREE_HEAT_FIELDS_H

#include "particles/particles.h"

/* Temperature of each particle, K; the power that flows into the particle, W; and the part of it that comes from
 * walls. NULL without heat. Borrowed until the set grows. */
double *heat_temperature(const struct particles *particles);
double *heat_flow(const struct particles *particles);
double *heat_wall_flow(const struct particles *particles);

/* True if particle i is a grain: the other kinds have no temperature of their own. */
bool heat_has(const struct particles *particles, size_t i);

/* The handle of the flow. */
int heat_flow_field(const struct particles *particles);

#endif
