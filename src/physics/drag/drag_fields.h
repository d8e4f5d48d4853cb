/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of drag, by particle number; pointers as of fields_values (kernel/particles/fields.h). */
#ifndef SCREE_DRAG_DRAG_FIELDS_H
#define SCREE_DRAG_DRAG_FIELDS_H

#include "kernel/particles/particles.h"

/* Force of the fluid on a grain by the law, three components, without buoyancy. */
double *drag_force(const struct particles *particles);

/* Adds the field of porosities, for laws that have one; the values, or NULL, and the handle. */
void drag_porosity_register(struct particles *particles);
double *drag_porosity(const struct particles *particles);
int drag_porosity_handle(const struct particles *particles);

#endif
