/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of an electrolyte, by particle number; pointers as of fields_values (kernel/particles/fields.h). */
#ifndef SCREE_CARRIED_ELECTROLYTE_FIELDS_H
#define SCREE_CARRIED_ELECTROLYTE_FIELDS_H

#include "engine/physics.h"

void electrolyte_fields(struct particles *particles);

/* Potential and charge density; the applied field, three components. */
double *electrolyte_potential(const struct particles *particles);
double *electrolyte_charge(const struct particles *particles);
double *electrolyte_field(const struct particles *particles);

/* Sends the potential to the copies. Collective. */
void electrolyte_fields_forward(const struct physics_context *context);

#endif
