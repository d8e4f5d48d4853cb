/* SPDX-License-Identifier: BSD-3-Clause */
/* Which places far from the surface of a closed mesh lie in its solid: a sign for each node of a lattice in the body's frame, whose spacing is less than the reach up to which
 * distances are exact. A place farther than that from the surface has the sign of the node nearest to it, as no surface lies between them. */
#ifndef SCREE_WALLS_WALL_BULK_H
#define SCREE_WALLS_WALL_BULK_H

#include "physics/grains/laws/law_kernel.h"
#include <stdbool.h>
#include <stdint.h>

struct wall_bulk {
    double reach, spacing;
    struct law_vector lower; /* the first node, outside of the mesh by two spacings */
    size_t count[3];
    uint8_t *solid; /* [z][y][x]; owned; NULL: the wall is no mesh */
};

/* Lays the lattice around a box; all nodes lie outside. Ends the program with a message where memory does not suffice. One thread. Destroy frees and nulls. */
struct wall_bulk *wall_bulk_create(struct law_vector lower, struct law_vector upper, double reach);
void wall_bulk_destroy(struct wall_bulk **bulk);

/* The place of node k. Any thread. */
struct law_vector wall_bulk_node(const struct wall_bulk *bulk, size_t k);

/* True if the node nearest to x (the body's frame) lies in the solid. Any thread. */
bool wall_bulk_solid(const struct wall_bulk *bulk, struct law_vector x);

#endif
