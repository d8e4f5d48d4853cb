/* SPDX-License-Identifier: BSD-3-Clause */
/* Forces summed in an order that no layout changes (scene key `reproducible`): what contacts give to
 * particles is written down, and added up when all is known, per particle by the partner's id, and by image
 * where the same two particles meet twice.
 *
 * Each side of a contact that a particle of this rank has is written down exactly once, by whichever thread
 * computes it. The law gives both sides of a pair the same bits whichever way round it is computed, and
 * separations are formed as (x_j - x_i) + shift from wrapped positions; so equal sets of contacts give equal
 * bits. Nobody but the force loop includes this. */
#ifndef SCREE_PAIRS_WALK_ORDERED_H
#define SCREE_PAIRS_WALK_ORDERED_H

#include <stddef.h>
#include <stdint.h>

/* Whom an entry comes from. */
struct walk_source {
    int64_t partner;
    uint32_t image; /* code of the partner's image, as seen from the particle */
};

/* What one thread has written down in this evaluation. */
struct walk_ledger {
    size_t count, capacity;
    uint32_t *particle; /* who gets it */
    struct walk_source *source;
    double *share; /* force_stride doubles an entry: force and torque */
};

/* Makes room for so many entries in all, of `stride` doubles. The thread itself. */
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
