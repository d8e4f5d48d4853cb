/* SPDX-License-Identifier: BSD-3-Clause */
/* The triangles of a mesh in a tree of boxes, for the triangle nearest to a place: a few dozen of triangles are looked at,
 * however many there are. Any thread may ask. */
#ifndef SCREE_WALLS_WALL_TREE_H
#define SCREE_WALLS_WALL_TREE_H

#include "physics/grains/walls/wall_touch.h"

struct wall_tree;

/* Borrows the mesh, which must live as long. One thread. Destroy frees and nulls. */
struct wall_tree *wall_tree_create(const struct wall_mesh *mesh);
void wall_tree_destroy(struct wall_tree **tree);

/* Finds the triangle nearest to x (body's frame) of those nearer than `reach`; false: there is none. */
bool wall_tree_nearest(const struct wall_tree *tree, struct law_vector x, double reach,
                       struct wall_nearest *near);

#endif
