/* SPDX-License-Identifier: BSD-3-Clause */
/* A division of the box by recursive bisection: a binary tree of cuts across the axes, with the ranks as its
 * leaves, for domain.c. The ranks of a node are a range [first, last), divided at `middle` into those below
 * and those above the cut. The nodes lie in one array: the lower child of a node follows directly, and the
 * upper child stands `middle - first` places behind the node. The tree takes 16 bytes a rank; a rank keeps no
 * other data of far ranks.
 *
 * A position on a cut belongs to the part above the cut. Subdomains may be empty (two cuts at one
 * coordinate). */
#ifndef SCREE_COMM_DOMAIN_TREE_H
#define SCREE_COMM_DOMAIN_TREE_H

#include "kernel/particles/box.h"
#include <math.h>
#include <stdbool.h>

struct domain_cut {
    double at;  /* coordinate, length unit */
    int middle; /* the first rank above the cut */
    int axis;
};

struct domain_tree {
    int ranks;
    struct domain_cut *cut; /* ranks - 1 */
};

/* Cuts into equal volumes across the longest edge each time. Owned by the caller (domain_tree_destroy). */
struct domain_tree *domain_tree_halve(int ranks, const struct box *box);

/* The tree whose subdomains have these corners, the ranks in the order of the cuts (lower ones first); axes
 * from `dimension` on are never cut. NULL if no such tree exists. */
struct domain_tree *domain_tree_from_bounds(int ranks, int dimension, const double (*lower)[3],
                                            const double (*upper)[3]);

/* The tree with these cuts (ranks - 1, as in struct domain_tree; copied), or NULL if they divide the whole
 * box `lower` ... `upper` into no subdomains of these ranks. */
struct domain_tree *domain_tree_from_cuts(int ranks, const struct domain_cut *cut, const double lower[3],
                                          const double upper[3]);
void domain_tree_destroy(struct domain_tree **tree);

/* Multiplies the coordinates of the cuts across an axis. */
void domain_tree_stretch(struct domain_tree *tree, int axis, double growth);

/* The rank that owns a position. */
int domain_tree_owner(const struct domain_tree *tree, const double x[3]);

/* Narrows the corners of the whole box to those of a rank's subdomain. */
void domain_tree_bounds(const struct domain_tree *tree, int rank, double lower[3], double upper[3]);

/* True if a cut lies across the axis. */
bool domain_tree_cuts(const struct domain_tree *tree, int axis);

/* Calls `put` for every rank whose subdomain is at most `radius` from the cuboid `from` ... `to`; `skip`:
 * axes along which distances do not count. `lower`, `upper`: the corners of the whole box. */
struct domain_tree_search {
    const double *from, *to;
    double radius;
    const bool *skip;
    void (*put)(void *context, int rank);
    void *context;
};
void domain_tree_near(const struct domain_tree *tree, const struct domain_tree_search *search,
                      const double lower[3], const double upper[3]);

/* The distance of [from, to] from [lower, upper]; 0 if the intervals meet. */
static inline double domain_gap(double lower, double upper, double from, double to) {
    return fmax(0, fmax(lower - to, from - upper));
}

#endif
