/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of the walls: the contacts of a sphere, each with its old record. */
#ifndef SCREE_WALLS_WALLS_HISTORY_H
#define SCREE_WALLS_WALLS_HISTORY_H

#include "physics/grains/walls/walls_parts.h"

/* Finds the contacts of candidate k, a sphere at x that reaches as far as `radius`, with the wall of the pieces from `first`
 * on, in scratch->touch, and for each the old record that it goes on with (-1: none), in scratch->from. Returns how many;
 * *last is the end of those pieces. */
size_t walls_find(const struct walls *walls, size_t k, size_t first, size_t *last, struct law_vector x,
                  double radius, struct wall_scratch *scratch);

/* Turns a spring from one normal to another. */
struct law_vector walls_carry(struct law_vector spring, struct law_vector from, struct law_vector to);

#endif
