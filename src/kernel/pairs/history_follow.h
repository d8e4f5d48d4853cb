/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds the partners of loose rows over a rebuild of several ranks, so that history_keep can note the rows by
 * local numbers as it notes the records of particles that stay. A partner is a copy, a particle that has just
 * arrived, or a particle that had a copy elsewhere; these are few, and only they go into a table of ids. */
#ifndef SCREE_PAIRS_HISTORY_FOLLOW_H
#define SCREE_PAIRS_HISTORY_FOLLOW_H

#include "kernel/pairs/history.h"

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

#endif
