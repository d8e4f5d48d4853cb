/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of the walls: signed distances from the surfaces of solid walls. */
#ifndef SCREE_WALLS_WALLS_FOOT_H
#define SCREE_WALLS_WALLS_FOOT_H

#include "physics/grains/walls/walls_parts.h"

/* The distance of x (the body's frame) from the surface of a mesh, negative in its solid; INFINITY beyond `reach`. Any thread. */
double walls_mesh_distance(const struct wall *wall, struct law_vector x, double reach);

/* The distance of a place in the wall's own image from the surface of a cylinder as it stands now. Any thread. */
double walls_cylinder_distance(const struct walls *walls, const struct wall *wall, struct law_vector here);

#endif
