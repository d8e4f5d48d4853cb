/* SPDX-License-Identifier: BSD-3-Clause */
/* The space that a closed surface of triangles encloses. */
#ifndef SCREE_WALLS_WALL_INSIDE_H
#define SCREE_WALLS_WALL_INSIDE_H

#include "physics/grains/walls/wall_mesh.h"

/* Reads a surface that must enclose a volume; `what` names the enclosed thing in messages ("a body"). `place` puts its
 * coordinates; its shift is added after the scale. Fails (user) if the file is none, the surface is not closed, or has triangles of both
 * orientations or more than 20,000. One thread; wall_mesh_destroy frees. */
bool wall_inside_read(struct wall_mesh **mesh, const char *file, const struct wall_mesh_place *place,
                      const char *what, struct error *error);

/* The distance from x to the closed surface; 0 outside, where the surface fills no solid angle. Its cost grows with the triangles.
 * Any thread. */
double wall_inside_depth(const struct wall_mesh *mesh, struct law_vector x);

/* The volume that a closed surface encloses. Any thread. */
double wall_inside_volume(const struct wall_mesh *mesh);

#endif
