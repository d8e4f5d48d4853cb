/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of a fluid, by particle number; pointers as of fields_values (particles/fields.h). */
#ifndef SCREE_FLUID_FIELDS_H
#define SCREE_FLUID_FIELDS_H

#include "particles/particles.h"

/* Pressure; of the fluid particles. */
double *fluid_pressure(const struct particles *particles);

/* Number of the connected region, 0 ...; of the fluid particles. */
int32_t *fluid_region(const struct particles *particles);

/* Number of the body (body.h); of the boundary particles. */
int64_t *fluid_body(const struct particles *particles);

#endif
