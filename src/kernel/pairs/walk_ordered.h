/* SPDX-License-Identifier: BSD-3-Clause */
/* Forces summed in an order that no layout changes (scene key `reproducible`): the shares of contacts are
 * written down, and added up when all are known. The shares of a particle are added in the order of the
 * partner's id, and of the image if the same two particles meet twice.
 *
 * Exactly one thread writes down each side of a contact of a particle of this rank. The law gives both sides
 * of a pair the same bits for both orders of the two particles, and separations are formed as (x_j - x_i) +
 * shift from wrapped positions; so equal sets of contacts give equal bits. Only the force loop includes this
 * file. */
#ifndef SCREE_PAIRS_WALK_ORDERED_H
#define SCREE_PAIRS_WALK_ORDERED_H

#include <stddef.h>
#include <stdint.h>

/* Source of an entry. */
struct walk_source {
    int64_t partner;
    uint32_t image; /* code of the partner's image, as seen from the particle */
};

/* The entries that one thread has written down in this evaluation. */
struct walk_ledger {
    size_t count, capacity;
    uint32_t *particle; /* the particle that gets the entry */
    struct walk_source *source;
    double *share; /* force_stride doubles an entry: force and torque */
};

/* Makes room for `entries` entries in all, of `stride` doubles each. Called by the ledger's own thread. */
void walk_ledger_reserve(struct walk_ledger *ledger, size_t entries, size_t stride);
void walk_ledger_free(struct walk_ledger *ledger);

struct walk_ordered; /* the ledgers of all threads, and room to sort them */
struct walk_ordered *walk_ordered_create(int threads);
void walk_ordered_destroy(struct walk_ordered **ordered);
struct walk_ledger *walk_ordered_ledger(struct walk_ordered *ordered, int thread);

/* Adds all entries to the forces of the particles [0, owned), and forgets them. Opens its own team. */
void walk_ordered_add(struct walk_ordered *ordered, size_t owned, double *force, size_t stride);

/* Forgets all entries. */
void walk_ordered_clear(struct walk_ordered *ordered);

#endif
