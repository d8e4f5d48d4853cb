/* SPDX-License-Identifier: BSD-3-Clause */
/* The nodes of the lattice on which fluid and boundary particles are placed. Each rank has all nodes of the
 * box, in memory of the set-up alone: 9 bytes a node. In an open direction the nodes go on beyond the box by
 * the support, for the boundary particles behind walls. */
#ifndef SCREE_FLUID_NODES_H
#define SCREE_FLUID_NODES_H

#include "engine/physics.h"
#include "fluid/fluid.h"

/* In a gap of fewer spacings the flow is not resolved. */
#define NODES_GAP 2.0

enum nodes_state { NODES_VOID, NODES_FLUID, NODES_SOLID };

/* A grain, of any rank. */
struct nodes_grain {
    double x[3], radius;
    int64_t id;
};

struct nodes {
    int dimension;
    double spacing, support, jitter, first[3]; /* place of node (0, 0, 0), box-relative */
    const struct box *box;
    uint64_t seed;
    int64_t count[3], all;
    uint8_t *state;
    int32_t *
        owner; /* SOLID: number of the grain, or, of a wall or an open side, its number as a body; FLUID: number of the region */
    float *depth;            /* SOLID: depth below the surface of the owner, length */
    int64_t narrow;          /* gaps between two grains of less than NODES_GAP spacings; contacts count */
    double narrowest;        /* length; INFINITY without a gap */
    int64_t narrowest_of[2]; /* the two grains */
    size_t grains;
    struct nodes_grain *grain;
};

/* Lays the nodes and finds what each is: fluid in the region, solid in grains and behind walls, else void. Meshes and
 * open sides are left to marks.h.
 * Fails (user) where the scene makes no sense. Collective; the same result on all ranks. */
bool nodes_make(struct nodes *nodes, const struct physics_context *context, struct error *error);
void nodes_free(struct nodes *nodes);

/* A node becomes solid, at a depth in the body `owner`, or goes on as the part of the body in which it lies deepest. */
void nodes_claim(struct nodes *nodes, int64_t node, int32_t owner, double depth);

/* The place of a node, box-relative and wrapped. Any thread. */
void nodes_place(const struct nodes *nodes, int64_t node, double x[3]);

/* The node `step` away from a node, -1 beyond an open side. Any thread. */
int64_t nodes_neighbour(const struct nodes *nodes, int64_t node, const int step[3]);

/* The steps to all nodes nearer than the support, allocated (memory_free). */
size_t nodes_steps(const struct nodes *nodes, int (**steps)[3]);

#endif
