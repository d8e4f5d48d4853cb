/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of the walls: which pieces of walls are near a place, and through which images. */
#ifndef SCREE_WALLS_WALLS_NEAR_H
#define SCREE_WALLS_WALLS_NEAR_H

#include "walls/walls_parts.h"

/* The pieces of wall w nearer than `reach` to x, sorted; returns how many. `out` has room for them, `number`
 * for the triangles; both may be NULL: counts only. */
size_t walls_near(const struct walls *walls, int w, struct law_vector x, double reach, struct wall_piece *out,
                  int32_t *number);

/* Says by how many periods the images that are looked at are away: of walls that move, wherever they are now,
 * and of those at rest that lie wholly outside of the box. When walls are made and at each walls_build. */
void walls_wrap(struct walls *walls);

#endif
