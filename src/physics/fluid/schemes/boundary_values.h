/* SPDX-License-Identifier: BSD-3-Clause */
/* Surfaces for which a scene gives values: walls, groups of grains, open sides. */
#ifndef SCREE_SCHEMES_BOUNDARY_VALUES_H
#define SCREE_SCHEMES_BOUNDARY_VALUES_H

#include "engine/physics.h"
#include "physics/fluid/fluid.h"

/* True if each of the surfaces of the list `key` ("fluid.scalars[0].given") names one wall, one group or one open side, and
 * no two name the same one; else a user's error with the key. */
bool boundary_values_suits(const struct physics_context *context, const char *key,
                           const struct fluid_surface *surface, int surfaces, struct error *error);

/* number[foot] = the number in the list of the surface on which a foot of the weights lies; -1: none. Sends the groups
 * of grains to their copies. Collective. */
void boundary_values_find(const struct physics_context *context, const struct weights *weights,
                          const struct fluid_surface *surface, int surfaces, int *number);

/* The number in the list of a body (body_surfaces.h), of a grain by its group (-1: none); -1: none. Any thread. */
int boundary_values_number(const struct fluid_surface *surface, int surfaces, int64_t body, int group);

#endif
