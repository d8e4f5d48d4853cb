/* SPDX-License-Identifier: BSD-3-Clause */
/* The short way of history.h over a rebuild: records of two particles that both stay on this rank stay where
 * they are and are found again by local numbers. The others (pairs with copies, particles that change ranks)
 * go as loose rows, keyed by ids; each row gets local numbers, too, when the new copies are known. Needs that no two particles can meet through several images. */
#ifndef SCREE_PAIRS_HISTORY_KEEP_H
#define SCREE_PAIRS_HISTORY_KEEP_H

#include "kernel/pairs/history.h"

/* Finds the partners of loose rows over a rebuild of several ranks, so that history_keep can note the rows by
 * local numbers as it notes the records of particles that stay. A partner is a copy, a particle that has just
 * arrived, or a particle that had a copy elsewhere; these are few, and only they go into a table of ids. */

/* Loose rows after the migration, and the particles among which their partners are. All borrowed. */
struct history_followers {
    const struct history_loose *loose; /* carriers by their numbers after the migration */
    const struct particles *particles; /* reordered, with the new copies: all of these may be partners */
    const uint32_t *near;              /* numbers after the migration of the other possible partners */
    size_t near_count;
};

/* A row and the present number of a particle that has the id of its partner: the particle or a copy. */
struct history_match {
    uint32_t row, number;
};

static inline uint32_t history_number(const uint32_t *now, uint32_t k) {
    return now ? now[k] : k;
}

/* The matches of all rows, by rows; rows without a partner here have none. `now` has the present number of
 * each number after the migration (NULL: the same). The caller frees the array (memory_free). Opens its own thread team. */
struct history_match *history_follow(const struct history_followers *followers, const uint32_t *now,
                                     size_t *count);

/* A record's partner and place. */
struct history_kept_entry {
    uint32_t partner; /* the higher of the two numbers */
    uint32_t record;  /* counted over the threads, one after another; HISTORY_KEPT_TURNED added if it is
                         oriented from the higher number to the lower */
};

#define HISTORY_KEPT_TURNED (UINT32_C(1) << 31)

/* The pair of a record, from which to which it is oriented; PARTICLE_LEFT: not a particle of this rank. */
struct history_link {
    uint32_t i, j; /* HISTORY_LINK_COPY is added to j if another thread holds the record, too */
};

#define HISTORY_LINK_COPY (UINT32_C(1) << 31)

/* Entries by the lower of the two new numbers: start[k] ... start[k + 1] - 1. Values stay in the history, and
 * in the loose rows. */
struct history_kept {
    uint32_t *start; /* owned + 1 entries, and one of scratch; NULL while there are links */
    struct history_kept_entry *entry;
    size_t owned;
    size_t first[PAIR_THREADS_MAX + 1]; /* number of each thread's first record; then of the first match */
    size_t
        own[PAIR_THREADS_MAX]; /* records of each thread, but those of pairs with copies, which come last */
    const struct history_row *row; /* the loose rows; borrowed */
    struct history_match *match;   /* record first[threads] + m is row[match[m].row] */
    uint64_t owners;               /* pairlist_owners of the list before */
    struct history_link *
        link; /* of each record, and behind of each match; left where all particles keep their numbers: entries
                                  are made only of those that the new list has in another order */
    size_t count; /* links */
};

/* Makes the entries from the links, which are freed. Opens its own thread team. */
void history_kept_sort(struct history_kept *kept, int threads);

/* The numbers of particles before and after a rebuild. */
struct history_numbers {
    const uint32_t
        *order;   /* of the reorder: new particle k was number order[k] after the migration; NULL: k */
    size_t owned; /* now */
    const uint32_t *place; /* number after the migration of each particle of the list; PARTICLE_LEFT: none.
                              NULL: no particle came or left */
    size_t before;         /* owned particles of the list, entries of place */
};

/* Notes the records of the list (which still has the numbers from before) by the new numbers, between the
 * reorder and the search, and the loose rows of `followers` (NULL: there are none); these are borrowed until
 * history_restore. Allocates; history_kept_free releases. Opens its own thread team. */
void history_keep(const struct history *history, const struct pairlist *list,
                  const struct history_numbers *numbers, const struct history_followers *followers,
                  struct history_kept *kept);

/* Copies of particles of this rank itself. A pair of the new list may have such a copy in place of the
 * original that it had before. The copies are the particles first ... first + count - 1, behind owned
 * particles and other copies; `original` has the number of the original of each. */
struct history_twins {
    size_t first, count;
    const uint32_t *original;
};

/* Hands the records and the loose rows to the pairs of the new list. Records stay where they are if `kept` has links, there are
 * no twins, and the list has the pairs in the same order, and the loose rows go behind them; else all go by entries, which are then
 * made in `kept`, to the other buffer of the history. Opens its own thread team. */
void history_restore(struct history *history, struct history_kept *kept, const struct history_twins *twins,
                     const struct pairlist *list);

void history_kept_free(struct history_kept *kept);

#endif
