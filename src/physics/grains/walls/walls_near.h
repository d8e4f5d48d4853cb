/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of the walls: the pieces of walls near a place, and their images. */
#ifndef SCREE_WALLS_WALLS_NEAR_H
#define SCREE_WALLS_WALLS_NEAR_H

#include "physics/grains/walls/walls_parts.h"

/* The pieces of wall w nearer than `reach` to x, sorted, triangles also where there is a field; returns their number. `out` has room for
 * the pieces, `number` for the triangles; both may be NULL: counts only. */
size_t walls_near(const struct walls *walls, int w, struct law_vector x, double reach, struct wall_piece *out,
                  int32_t *number);

/* True if nothing moves or turns a particle: such a particle has no contact with a wall at rest, for any
 * overlap. */
bool walls_at_rest(const struct particles *particles, size_t i);

/* Sets the periods by which the images of walls are shifted: for walls that move, by their present place,
 * and for walls at rest that lie wholly outside of the box. Called when walls are made and at each
 * walls_build. */
void walls_wrap(struct walls *walls);

#endif
