/* SPDX-License-Identifier: BSD-3-Clause */
/* The pairs that this rank solves, each once, in the order of their colours (colour.h), and what their contacts
 * remember: the force of the last step, from which the next one starts. Made anew at each rebuild from the pair list.
 *
 * Of a pair across ranks one rank has the contact: with newton on the rank whose list has it, with newton off the
 * owner of the lower id. */
#ifndef SCREE_HARD_PAIRS_H
#define SCREE_HARD_PAIRS_H

#include "physics/hard/clumps.h"
#include "physics/hard/colour.h"
#include "kernel/pairs/history.h"
#include "kernel/particles/box.h"

/* The force of a contact in the last step: along the normal, and in the tangent plane on the second particle. All 0:
 * it had none. */
struct hard_memory {
    double push, rub[3];
};
enum { HARD_MEMORY = 4, HARD_MEMORY_ODD = 3 }; /* doubles of a record, vectors first */

struct hard_pairs {
    struct hard_colours colours;
    uint32_t (*end)[2]; /* numbers of the particles, owned or copies */
    uint8_t *image;     /* image code of the second one */
    uint32_t *number;   /* of the pair in the list */
    struct hard_memory *memory;
    struct history *history; /* records on their way into and out of rows */
    struct history_rows
        rows; /* by owned particle, from hard_pairs_detach to hard_pairs_make; else start NULL */
};

void hard_pairs_create(struct hard_pairs *pairs, int threads);
void hard_pairs_free(struct hard_pairs *pairs);

/* Takes the pairs of a new list, with the memory that `rows` has, which are released. Colours are those of bodies, of which a pair
 * of members has the bodies that carry these. One thread opens teams of its own. */
void hard_pairs_make(struct hard_pairs *pairs, const struct pairlist *list, const struct particles *particles,
                     const struct box *box, bool newton, const struct hard_clumps *clumps);

/* Turns what contacts remember into rows, unless rows are there already. */
void hard_pairs_detach(struct hard_pairs *pairs, const struct pairlist *list,
                       const struct particles *particles);

#endif
