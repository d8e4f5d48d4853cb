/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of the walls: the contacts of one sphere, and the scratch of a thread. */
#ifndef SCREE_WALLS_WALLS_TOUCH_H
#define SCREE_WALLS_WALLS_TOUCH_H

#include "physics/grains/walls/walls_parts.h"

/* A cylinder wall as it stands now. */
struct wall_cylinder walls_cylinder(const struct wall *wall);

/* The contacts of a sphere at x with one wall, whose pieces these are; written to scratch->touch, normals in
 * space. Returns the number of contacts. */
size_t walls_touch(const struct walls *walls, const struct wall_piece *piece, size_t pieces,
                   struct law_vector x, double radius, struct wall_scratch *scratch);

/* The same for a particle at x whose first piece has a `face`. */
size_t walls_touch_face(const struct walls *walls, const struct wall_piece *piece, struct law_vector x,
                        double radius, struct wall_scratch *scratch);

/* The normal half a step ago. */
struct law_vector walls_half_normal(const struct wall *wall, const struct wall_touch *touch,
                                    const struct wall_sphere *sphere, double dt);

/* Direction and distance from x to a feature of a wall. */
struct law_vector walls_toward(const struct wall *wall, int32_t feature, struct law_vector x,
                               double *distance);

/* Number of features of a wall. */
size_t walls_features(const struct wall *wall);

/* Makes room in a thread's scratch; frees its arrays. */
void walls_scratch_reserve(struct wall_scratch *scratch, size_t pieces);
void walls_scratch_free(struct wall_scratch *scratch);

#endif
