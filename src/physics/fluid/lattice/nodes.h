/* SPDX-License-Identifier: BSD-3-Clause */
/* The nodes of the lattice on which fluid and boundary particles are placed, in memory of the set-up alone: 9 bytes a
 * node. The planes across the last direction are dealt out between the ranks. A rank holds its own planes and those
 * within the support of them; `node` is a number among the nodes that it holds, 0 ... all - 1, and nodes_number that on
 * the whole lattice. In an open direction the nodes go on beyond the box by the support, for the boundary particles
 * behind walls. */
#ifndef SCREE_LATTICE_NODES_H
#define SCREE_LATTICE_NODES_H

#include "engine/physics.h"
#include "physics/fluid/fluid.h"
#include "physics/fluid/lattice/arrangement.h"

/* ABSENT: the lattice has no node of these numbers (arrangement.h). */
enum nodes_state { NODES_VOID, NODES_FLUID, NODES_SOLID, NODES_ABSENT };

/* A grain, of any rank. */
struct nodes_grain {
    double x[3], radius;
    int64_t id;
};

struct nodes {
    int dimension;
    double spacing, support, jitter, first[3]; /* place of node (0, 0, 0) of the lattice, box-relative */
    struct arrangement lattice;
    const struct box *box;
    const struct comm *comm;
    uint64_t seed;
    int64_t whole[3];      /* nodes of the lattice in each direction */
    int cut;               /* the direction whose planes are dealt out, the slowest one of numbers of nodes */
    int64_t plane;         /* the first plane held, below 0 if it lies across a periodic side */
    int64_t own[2];        /* own planes: own[0] ... own[1] - 1 */
    int64_t count[3], all; /* nodes held */
    uint8_t *state;
    int32_t *
        owner; /* SOLID: number of the grain, or, of a wall or an open side, its number as a body; FLUID: number of the region */
    float *depth;   /* SOLID: depth below the surface of the owner, length */
    int64_t wanted; /* nodes in the region and in the box, of all ranks */
    size_t grains;
    struct nodes_grain *grain; /* by x */
};

/* Lays the nodes and finds what each is: fluid in the region, solid in grains and behind walls that bound the fluid, else void. Meshes and
 * open sides are left to surface_marks.h.
 * Fails (user) where the scene makes no sense. Collective; a node is the same on all ranks that hold it. */
bool nodes_make(struct nodes *nodes, const struct physics_context *context, struct error *error);
void nodes_free(struct nodes *nodes);

/* A node becomes solid, at a depth in the body `owner`, or goes on as the part of the body in which it lies deepest. */
void nodes_claim(struct nodes *nodes, int64_t node, int32_t owner, double depth);

/* Deals the planes out between the ranks: sets cut, plane, own, count and all; the other lengths and counts are given. */
void nodes_deal(struct nodes *nodes);

/* The number of a node on the whole lattice, and the place of a node of that number, box-relative and wrapped. Any
 * thread. */
int64_t nodes_number(const struct nodes *nodes, int64_t node);
void nodes_place(const struct nodes *nodes, int64_t number, double x[3]);

/* The plane of a node, and whether it is one of this rank's own. Any thread. */
int64_t nodes_plane(const struct nodes *nodes, int64_t node);
bool nodes_own(const struct nodes *nodes, int64_t node);

/* The rank whose own plane this is, of planes 0 ... whole[cut] - 1. */
int nodes_rank_of(const struct nodes *nodes, int64_t plane);

/* The node `step` away from a node, -1 beyond an open side or the planes held: from an own node, steps within the
 * support stay in these. Any thread. */
int64_t nodes_neighbour(const struct nodes *nodes, int64_t node, const int step[3]);

#endif
