/* SPDX-License-Identifier: BSD-3-Clause */
/* Triangles of walls that are named by their shape:
 *
 *   rectangle  two triangles between the sides `along` and `across` of a corner; exact. Sides that are not at right
 *              angles make a parallelogram. Its normal is along x across
 *   box        twelve triangles; exact. Their normals point outwards
 *   disc       a regular polygon of `segments` corners on the circle, less one on the rim of the hole
 *   cone       a frustum without ends of `segments` plane sides, with corners on the circles. Its normals point away
 *              from the axis
 *
 * A polygon of n corners lies within r (1 - cos(pi / n)) of its circle, 5e-4 r for 96. Sides that meet at less than
 * WALL_TOUCH_SMOOTH (wall_touch.h; 42 segments or more) act as one smooth surface. */
#ifndef SCREE_WALLS_MESH_SHAPE_H
#define SCREE_WALLS_MESH_SHAPE_H

#include "physics/grains/walls/mesh.h"
#include "physics/grains/walls/wall.h"

/* Makes the triangles in the user's coordinates; mesh_free releases. Fails (user) on lengths from which no surface
 * follows. One thread. */
bool mesh_shape_make(struct mesh *mesh, const struct wall_options *options, struct error *error);

#endif
