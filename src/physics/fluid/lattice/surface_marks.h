/* SPDX-License-Identifier: BSD-3-Clause */
/* Which nodes of the lattice lie in the solids of meshes, and which beyond open sides. */
#ifndef SCREE_LATTICE_SURFACE_MARKS_H
#define SCREE_LATTICE_SURFACE_MARKS_H

#include "physics/fluid/lattice/nodes.h"

/* Marks nodes in the solids of meshes, then nodes beyond open sides of the box, as far as nothing else claims these. After
 * nodes_make. Opens its own team. */
void surface_marks_make(struct nodes *nodes, const struct physics_context *context);

#endif
