/* SPDX-License-Identifier: BSD-3-Clause */
/* Parts of the filling of a lattice: open sides, and marks of surfaces. */
#ifndef SCREE_PHYSICS_FLUID_LATTICE_LATTICE_FILL_PARTS_H
#define SCREE_PHYSICS_FLUID_LATTICE_LATTICE_FILL_PARTS_H

#include "physics/fluid/lattice/nodes.h"
#include "physics/fluid/lattice/regions.h"

/* What the open sides of the box need of the lattice. */

/* True if fluid lies at each open side; where no side has a pressure, if as much flows in as out; where one has, if each
 * connected region reaches such a side. Else a user's error with the key. Collective. */
bool lattice_fill_open_suits(const struct nodes *nodes, const struct regions *regions,
                             const struct physics_context *context, struct error *error);

/* Which nodes of the lattice lie in the solids of meshes, and which beyond open sides. */

/* Marks nodes in the solids of meshes, then nodes beyond open sides of the box, as far as nothing else claims these. After
 * nodes_make. Opens its own team. */
void surface_marks_make(struct nodes *nodes, const struct physics_context *context);

#endif
