/* SPDX-License-Identifier: BSD-3-Clause */
/* Triangles of a mesh binned into cells, in the body's frame: made once, as a wall that moves is asked in its
 * own frame. */
#ifndef SCREE_WALLS_WALL_GRID_H
#define SCREE_WALLS_WALL_GRID_H

#include "physics/grains/walls/wall_mesh.h"

struct wall_grid;

/* Bins the triangles of a mesh, which must live as long as the grid. One thread. Destroy frees and nulls. */
struct wall_grid *wall_grid_create(const struct wall_mesh *mesh);
void wall_grid_destroy(struct wall_grid **grid);

/* The triangles that come nearer than `reach` to x (body's frame), each once, in no order: writes their
 * numbers to `out`, or only counts them if `out` is NULL. Returns their number. Any thread. */
size_t wall_grid_query(const struct wall_grid *grid, struct law_vector x, double reach, int32_t *out);

#endif
