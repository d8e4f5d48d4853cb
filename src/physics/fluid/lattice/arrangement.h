/* SPDX-License-Identifier: BSD-3-Clause */
/* Lattices. A node has three whole numbers, `step` apart in each direction; on other lattices than the cubic one some
 * numbers have no node:
 *
 *   cubic       all numbers; the step is the spacing, and the spacing divides periodic edges
 *   bcc         numbers that are all even or all odd: two nodes in a cube of two steps; three dimensions
 *   fcc         x + y + z even: four nodes in a cube of two steps, each with twelve neighbours; three dimensions
 *   hexagonal   x + y even: rows of nodes, each between two of the next row; two dimensions
 *
 * The spacing is the edge of a square or cube with the volume of a node, so that all lattices of one spacing have as many
 * nodes. The lattices other than the cubic one are stretched, by a factor in each direction, until they fit the box. */
#ifndef SCREE_LATTICE_ARRANGEMENT_H
#define SCREE_LATTICE_ARRANGEMENT_H

#include "physics/fluid/fluid.h"

struct physics_context;

/* The largest part by which a lattice may be stretched. */
#define ARRANGEMENT_STRETCH 0.1

struct arrangement {
    enum fluid_arrangement arrangement;
    int dimension;
    double step[3];    /* length; in two dimensions the third one is the spacing */
    int64_t planes[3]; /* steps in an edge of the box; of the cubic lattice the nearest whole number */
    double volume;     /* of a node, length^dimension */
    double stretch;    /* the largest part by which a step differs from that of the lattice of this spacing */
};

struct arrangement arrangement_make(const struct fluid_options *options, const struct box *box);

/* Refuses a lattice that does not go with the dimensions or the edges of the box. */
bool arrangement_suits(const struct arrangement *lattice, const struct physics_context *context,
                       struct error *error);

/* True if there is a node of these numbers, which may be negative; of differences of numbers: true if the difference leads
 * from node to node. Any thread. */
static inline bool arrangement_has(const struct arrangement *lattice, const int64_t at[3]) {
    if (lattice->arrangement == FLUID_HEXAGONAL || lattice->arrangement == FLUID_FCC)
        return ((at[0] ^ at[1] ^ at[2]) & 1) == 0;
    return lattice->arrangement == FLUID_CUBIC || (((at[0] ^ at[1]) | (at[1] ^ at[2])) & 1) == 0;
}

/* The differences of numbers along the edges of the lattice, to a next plane at most; returns how many. */
int arrangement_edges(const struct arrangement *lattice, const int (**steps)[3]);

/* The differences of numbers to all nodes nearer than `reach`, allocated (memory_free); returns how many. */
size_t arrangement_around(const struct arrangement *lattice, double spacing, double reach, int (**steps)[3]);

#endif
