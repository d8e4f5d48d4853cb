/* SPDX-License-Identifier: BSD-3-Clause */
/* The pairs of a packing that may overlap, found by the program's own index and kept in its own pair list
 * while particles move. */
#ifndef SCREE_PACK_PACK_SEARCH_H
#define SCREE_PACK_PACK_SEARCH_H

#include "base/error.h"
#include "index/index.h"
#include "kernel/pairs/pairlist.h"
#include "kernel/particles/particles.h"

struct pack_search {
    struct particles *particles; /* borrowed */
    const struct box *box;       /* borrowed */
    int threads;
    struct size_classes classes;
    struct index *index; /* owned, as the list */
    struct pairlist *list;
    double moved[CLASS_MAX]; /* no particle of the class has moved farther since the last search; length */
    uint64_t searches;
};

/* Makes a search for pairs nearer than (1 + gap) times the sum of their radii; sets the classes of the
 * particles, whose radii must stay. NULL: error filled. Destroy frees it and nulls the pointer. Opens its own
 * thread team, as all here. */
struct pack_search *pack_search_create(struct particles *particles, const struct box *box, double gap,
                                       int threads, struct error *error);
void pack_search_destroy(struct pack_search **search);

/* Wraps and sorts the particles, and lists all such pairs and those a skin farther apart. */
void pack_search_run(struct pack_search *search);

/* Adds to the displacements since the last search, by class. True if the list may miss a pair from now on. */
bool pack_search_moved(struct pack_search *search, const double largest[CLASS_MAX]);

#endif
