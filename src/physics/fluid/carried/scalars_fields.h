/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of scalars, by particle number; pointers as of fields_values (kernel/particles/fields.h). */
#ifndef SCREE_CARRIED_SCALARS_FIELDS_H
#define SCREE_CARRIED_SCALARS_FIELDS_H

#include "engine/physics.h"

/* Adds the fields of the first `count` scalars. */
void scalars_fields(struct particles *particles, int count);

/* Values of scalar k, 0 ..., and those of the step before. */
double *scalars_value(const struct particles *particles, int k);
double *scalars_before(const struct particles *particles, int k);

/* Sends the values of scalar k to the copies. Collective. */
void scalars_fields_forward(const struct physics_context *context, int k);

#endif
