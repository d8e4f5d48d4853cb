/* SPDX-License-Identifier: BSD-3-Clause */
/* Scratch of a pair list build, for pairlist*.c and interaction.c alone. The scratch lives as long as the
 * list, so that a rebuild allocates nothing new. */
#ifndef SCREE_PAIRS_PAIRLIST_BUILD_H
#define SCREE_PAIRS_PAIRLIST_BUILD_H

#include "kernel/pairs/pairlist.h"

enum { PAIR_NO_THREAD = 255 };

/* A growing array of pairs. */
struct pair_buffer {
    uint32_t *i, *j;
    size_t count, capacity;
};

/* Second copies of pairs, sorted by the threads that take them: those of thread t end at end[t]. */
struct pair_shares {
    struct pair_buffer pairs;
    size_t end[PAIR_THREADS_MAX];
};

/* One thread's part of a build. */
struct pairlist_worker {
    struct index_sink sink; /* pairs that the index finds in one block */
    struct pair_buffer one; /* the block's one-sided pairs, and its pairs with busy partners */
    struct pair_buffer slot;
    struct pair_buffer mirror;          /* pairs (j, i) for other threads */
    struct pair_buffer ghost;           /* pairs with ghosts */
    struct pair_shares mirrors, ghosts; /* of `mirror` and `ghost`, those for other threads */
    size_t first, room, used;           /* region of the list; used > room: too small, counted only */
    size_t primary;
    uint64_t partners[CLASS_MAX]; /* how often a particle of the class is in a pair */
};

/* Owned particles of one size class that lie together: [first, last). */
struct class_run {
    size_t first, last;
    int size_class;
};

struct pairlist_build {
    struct pairlist_worker *worker; /* one a thread */
    uint8_t *thread_of; /* total entries: the thread that owns a particle, or meets a ghost first */
    size_t thread_of_capacity;
    struct class_run *run; /* of the last build */
    size_t run_count, run_capacity;
    uint64_t population[CLASS_MAX]; /* particles of each class, ghosts included */
    bool busy_class[CLASS_MAX];
    double busy_bound;
    size_t block_rows;
    int blocks_capacity;
};

/* Makes the blocks of the list, in order by thread: those of its rows, then one for mirrors and one for ghosts; notes the
 * thread of each particle. */
void pairlist_blocks_make(struct pairlist *list, const struct index_view *view);

void pair_buffer_free(struct pair_buffer *buffer);

/* Gives each ghost that thread t meets to the first thread that meets the ghost: threads lower its number to their
 * own, and the order in which they do so does not matter. Many threads at once, each with its own t. */
void pairlist_shares_meet(struct pairlist *list, int t);

/* Sort the pairs of thread t by the threads that take their second copies, so that no thread looks through the pairs of
 * all; those with ghosts once all threads have met their ghosts. Many threads at once, each with its own t. */
void pairlist_shares_mirrors(struct pairlist *list, int t);
void pairlist_shares_ghosts(struct pairlist *list, const struct index_view *view, int t);

/* The first pair of the share of thread t. */
static inline size_t pairlist_shares_first(const struct pair_shares *shares, int t) {
    return t > 0 ? shares->end[t - 1] : 0;
}

/* Makes room for `particles` slot numbers and for `slots` slots; keeps the present ones. */
void pairlist_reserve_slots(struct pairlist *list, size_t particles, size_t slots);

#endif
