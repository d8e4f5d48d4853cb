/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of the walls: the old record of each contact. */
#ifndef SCREE_WALLS_WALLS_HISTORY_H
#define SCREE_WALLS_WALLS_HISTORY_H

#include "physics/grains/walls/walls_parts.h"

/* Finds, for each of the `count` contacts with wall w in scratch->touch, the old record of candidate k that
 * the contact goes on with, in scratch->from. */
void walls_recall(const struct walls *walls, size_t k, int w, size_t count, struct law_vector x,
                  double radius, struct wall_scratch *scratch);

/* Sorts contacts with one feature through several images of its wall by image, each among the places that
 * they have. A wrapped particle changes the images, not their order. */
void walls_sort_images(struct wall_touch *touch, size_t count);

/* Turns a spring from one normal to another. */
struct law_vector walls_carry(struct law_vector spring, struct law_vector from, struct law_vector to);

#endif
