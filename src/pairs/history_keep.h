/* The short way of history.h over a rebuild on which no particle comes, goes or changes ranks: records stay
 * where they are and are found again by old local numbers; nothing is keyed by ids. Needs that no two
 * particles can meet through several images. */
#ifndef SCREE_PAIRS_HISTORY_KEEP_H
#define SCREE_PAIRS_HISTORY_KEEP_H

#include "pairs/history.h"

/* A record's partner and place. */
struct history_kept_entry {
    uint32_t partner; /* old number */
    uint32_t record;  /* counted over the threads, one after another */
};

/* Rows by old number of the row particle: entries start[k] ... start[k + 1] - 1. Values stay in the history.
 */
struct history_kept {
    uint64_t *mask;  /* of each row: bits of its records' partners, so that most pairs without a record are
                        told at  a glance */
    uint32_t *start; /* owned + 1 entries; NULL: nothing kept */
    struct history_kept_entry *entry;
    size_t owned;
    size_t first[PAIR_THREADS_MAX + 1]; /* number of each thread's first record */
};

/* Notes the records of the list, before the particles are reordered. Allocates; history_kept_free releases.
 * Opens its own thread team. */
void history_keep(const struct history *history, const struct pairlist *list, size_t owned,
                  struct history_kept *kept);

/* Hands the records to the pairs of the new list; `order` is that of the reorder between (new particle k is
 * the old order[k]). Opens its own thread team. */
void history_restore(struct history *history, const struct history_kept *kept, const uint32_t *order,
                     const struct pairlist *list);

void history_kept_free(struct history_kept *kept);

#endif
