/* SPDX-License-Identifier: BSD-3-Clause */
/* Relaxation: particles move out of each other until none overlap.
 *
 * A sweep looks at all pairs at once and then moves all particles (Jacobi). A pair that is nearer than (1 +
 * gap) times the sum of its radii pushes both apart along the line of centres with the stiffness k = (r_i r_j
 * / (r_i + r_j))^2. A particle moves by 2 (sum of k times distance) / (2 max(largest k, sum of k / 3)). So
 * two particles of a single contact end as far apart as they overlapped, a particle in a shell of small ones
 * moves as a whole, and two large ones part as fast as two small ones. Because of the gap the overlaps proper
 * end after finitely many sweeps. The region puts a particle back to the place of first touch.
 * A particle that stays pushes as one that moves, and its partner goes the whole way.
 *
 * Pushes are summed as whole numbers, and both sides of a pair round alike. So the sums, and with them every
 * position, are the same bits for any number of threads and any order in memory. */
#ifndef SCREE_DATA_SCENE_PACK_RELAX_H
#define SCREE_DATA_SCENE_PACK_RELAX_H

#include "base/error.h"
#include "data/scene/pack/pack_search.h"
#include "data/scene/pack/pile.h"

/* State of a relaxation. */
struct relax_state {
    int sweep;         /* from 1 */
    double overlap;    /* the largest, relative to the smaller particle's radius; 0: there is none */
    uint64_t searches; /* for pairs, so far */
};

struct relax_options {
    double gap;   /* wanted between neighbours, as part of the sum of radii; > 0 */
    double bound; /* the end: no overlap is larger, relative to the smaller particle's radius; >= 0 */
    int sweeps;   /* at most */
    int threads;
    void (*show)(void *context, const struct relax_state *state); /* after each sweep; NULL: none */
    void *context;
};

/* Relaxes the spheres of a pile, each of which lies in its region. Regions must be wider than the largest sphere; in periodic
 * directions the box must be wider than 1.25 times the diameter of the largest sphere. The largest radius may be 1000 times the smallest. The
 * order of the spheres changes. Overlaps of two spheres that stay do not count. Fails (user) if `sweeps` sweeps leave larger overlaps. `state`
 * is that of the end: its overlap comes from a new search. Opens its own thread team. */
bool relax_run(const struct pile *pile, const struct relax_options *options, struct relax_state *state,
               struct error *error);

/* One sweep of the relaxation. See relax.h. */

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
