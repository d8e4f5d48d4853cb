/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of heat. */
#ifndef SCREE_HEAT_HEAT_FIELDS_H
#define SCREE_HEAT_HEAT_FIELDS_H

#include "kernel/particles/particles.h"

/* Temperature of each particle, K; the power that flows into the particle, W; and the part of it that comes from
 * walls. NULL without heat. Borrowed until the set grows. */
double *heat_temperature(const struct particles *particles);
double *heat_flow(const struct particles *particles);
double *heat_wall_flow(const struct particles *particles);

/* The work of a grain's contacts in the last step: taken and held (heat_work.h), two doubles a particle; and what they held a step
 * before. NULL without heat.dissipation. */
double *heat_work_field(const struct particles *particles);
double *heat_held_field(const struct particles *particles);
void heat_work_register(struct particles *particles);

/* True if particle i is a grain: the other kinds have no temperature of their own. */
bool heat_has(const struct particles *particles, size_t i);

/* The handle of the flow. */
int heat_flow_field(const struct particles *particles);

#endif
