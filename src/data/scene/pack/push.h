/* SPDX-License-Identifier: BSD-3-Clause */
/* One sweep of the relaxation. See relax.h. */
#ifndef SCREE_PACK_PUSH_H
#define SCREE_PACK_PUSH_H

#include "data/scene/pack/pile.h"
#include "data/scene/pack/pack_search.h"

/* The pushes on a particle in whole numbers: the sum of stiffness times distance, the sum of stiffnesses and
 * the largest one. */
struct push_sum {
    int64_t push[3], stiffness, stiffest;
};

struct pushes {
    double smallest;        /* radius */
    double gap;             /* between spheres, as part of the sum of their radii */
    struct push_sum *sum;   /* of each particle */
    struct push_sum **slot; /* of each thread, for the busy particles of the pair list */
    size_t slots;           /* in each of them */
    int threads;
};

/* Makes the scratch of sweeps over `count` particles, the smallest of radius `smallest`. Destroy frees it and
 * nulls the pointer. */
struct pushes *push_create(size_t count, double smallest, double gap, int threads);
void push_destroy(struct pushes **pushes);

/* Adds up the pushes of all pairs. Returns the largest overlap, relative to the smaller radius; 0 if there is
 * none. Opens its own thread team. */
double push_all(struct pushes *pushes, const struct pack_search *search);

/* Moves all particles by `factor` times their pushes, within their regions, and clears the pushes; `largest` gets the largest
 * displacement of each class. Opens its own thread team. */
void push_move(struct pushes *pushes, const struct pile *pile, double factor, double largest[CLASS_MAX]);

#endif
