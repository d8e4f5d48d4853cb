/* SPDX-License-Identifier: BSD-3-Clause */
/* Spheres of a packing on their way: each moves in the region of its part, clear of walls, or stays where it is.
 * Places are box-relative. */
#ifndef SCREE_PACK_PILE_H
#define SCREE_PACK_PILE_H

#include "data/scene/placegrid.h"
#include "data/scene/region.h"
#include "data/scene/scene_share.h"
#include "kernel/particles/particles.h"

/* The spheres of one source: those with an id below `end`, and not below that of the part before. */
struct pile_part {
    struct region region; /* the user's coordinates */
    struct region_space space;
    int64_t end;
};

struct pile {
    struct particles *particles; /* inverse_mass 1: moves; 0: stays. Any order; owned */
    const struct box *box;
    const struct scene_share *share; /* tells which places walls take */
    uint64_t seed;
    double gap; /* kept to walls, as part of the radius */
    int parts;
    const struct pile_part *part;
    struct placegrid *still; /* spheres that stay; owned */
};

/* Makes an empty pile: particles and still; the caller sets the rest. `smallest`: radius of the spheres that will stay. pile_free releases both. */
struct pile pile_create(const struct box *box, double smallest);
void pile_free(struct pile *pile);

/* Adds a sphere that moves, without a place, or one that stays at x. */
void pile_add(struct pile *pile, int64_t id, double radius);
void pile_add_still(struct pile *pile, const double x[3], double radius);

/* Gives random places, clear of spheres that stay, to all spheres that move: that of a sphere depends on seed and id alone. Returns the largest
 * radius for which no place was found, 0 if there is none. Opens its own thread team. */
double pile_place(const struct pile *pile);

/* Brings sphere k, which moved from its place to x, back into its region and clear of walls; changes x. Any thread. */
void pile_hold(const struct pile *pile, size_t k, double x[3]);

#endif
