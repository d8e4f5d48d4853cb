/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of walls.c: areas of walls, and the forces that follow from pressures. */
#ifndef SCREE_WALLS_WALL_AREA_H
#define SCREE_WALLS_WALL_AREA_H

#include "physics/grains/walls/walls_parts.h"

/* Gives each servo of wall `wall` that is driven to a pressure its force, and its area where the user gives none,
 * in the wall's options. Fails (user) where no area follows from the wall's shape. One thread, before the
 * wall's motions are made. */
bool wall_area_targets(struct walls *walls, int wall, struct error *error);

#endif
