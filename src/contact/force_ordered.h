/* Forces summed in an order that no layout changes (scene key `reproducible`): what contacts give to
 * particles is written down, and added up when all is known, per particle by the partner's id, and by image
 * where the same two particles meet twice.
 *
 * Each side of a contact that a particle of this rank has is written down exactly once, by whichever thread
 * computes it. The law gives both sides of a pair the same bits whichever way round it is computed, and
 * separations are formed as (x_j - x_i) + shift from wrapped positions; so equal sets of contacts give equal
 * bits. Nobody but the force loop includes this. */
#ifndef SCREE_CONTACT_FORCE_ORDERED_H
#define SCREE_CONTACT_FORCE_ORDERED_H

#include <stddef.h>
#include <stdint.h>

/* Whom an entry comes from. */
struct force_source {
    int64_t partner;
    uint32_t image; /* code of the partner's image, as seen from the particle */
};

/* What one thread has written down in this evaluation. */
struct force_ledger {
    size_t count, capacity;
    uint32_t *particle; /* who gets it */
    struct force_source *source;
    double *share; /* force_stride doubles an entry: force and torque */
};

/* Makes room for so many entries in all, of `stride` doubles. The thread itself. */
void force_ledger_reserve(struct force_ledger *ledger, size_t entries, size_t stride);
void force_ledger_free(struct force_ledger *ledger);

struct force_ordered; /* the ledgers of all threads, and room to sort them */
struct force_ordered *force_ordered_create(int threads);
void force_ordered_destroy(struct force_ordered **ordered);
struct force_ledger *force_ordered_ledger(struct force_ordered *ordered, int thread);

/* Adds all entries to the forces of the particles [0, owned), and forgets them. Opens its own team. */
void force_ordered_add(struct force_ordered *ordered, size_t owned, double *force, size_t stride);

/* Forgets all entries. */
void force_ordered_clear(struct force_ordered *ordered);

#endif
