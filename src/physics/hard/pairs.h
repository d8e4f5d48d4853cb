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
#include "physics/hard/resist.h"
#include "kernel/pairs/history.h"
#include "kernel/particles/box.h"
#include <string.h>

/* The force of a contact in the last step: along the normal, and in the tangent plane on the second particle. All 0:
 * it had none. */
struct hard_memory {
    double push, rub[3];
};

/* Doubles of a record, vectors first: rub, push; with resistances rub, roll, push, twist. */
enum { HARD_MEMORY = 4, HARD_MEMORY_ODD = 3, HARD_MEMORY_RESISTS = 8, HARD_MEMORY_RESISTS_ODD = 6 };

struct hard_pairs {
    struct hard_colours colours;
    uint32_t (*end)[2]; /* numbers of the particles, owned or copies */
    uint8_t *image;     /* image code of the second one */
    uint32_t *number;   /* of the pair in the list */
    struct hard_memory *memory;
    bool resists;
    struct hard_couple *couple; /* of rolling and twisting; NULL: no contact resists */
    struct history *history;    /* records on their way into and out of rows */
    struct history_rows
        rows; /* by owned particle, from hard_pairs_detach until all have taken theirs; else start NULL */
};

/* `resists`: contacts remember rolling and twisting, too. */
void hard_pairs_create(struct hard_pairs *pairs, int threads, bool resists);
void hard_pairs_free(struct hard_pairs *pairs);

/* Takes the pairs of a new list, with the memory that `rows` has. Colours are those of bodies, of which a pair
 * of members has the bodies that carry these. One thread opens teams of its own. */
void hard_pairs_make(struct hard_pairs *pairs, const struct pairlist *list, const struct particles *particles,
                     const struct box *box, bool newton, const struct hard_clumps *clumps);

/* The numbers of a record. `couple` is read and written where contacts resist. Any thread. */
static inline void hard_memory_put(const struct hard_pairs *pairs, const struct hard_memory *memory,
                                   const struct hard_couple *couple, double *value) {
    memcpy(value, memory->rub, sizeof memory->rub);
    value[pairs->history->odd] = memory->push;
    if (!pairs->resists)
        return;
    memcpy(value + HARD_MEMORY_ODD, couple->roll, sizeof couple->roll);
    value[HARD_MEMORY_RESISTS_ODD + 1] = couple->twist;
}

static inline void hard_memory_get(const struct hard_pairs *pairs, const double *value,
                                   struct hard_memory *memory, struct hard_couple *couple) {
    memcpy(memory->rub, value, sizeof memory->rub);
    memory->push = value[pairs->history->odd];
    if (!pairs->resists)
        return;
    memcpy(couple->roll, value + HARD_MEMORY_ODD, sizeof couple->roll);
    couple->twist = value[HARD_MEMORY_RESISTS_ODD + 1];
}

/* Turns what contacts remember into rows, unless rows are there already. */
void hard_pairs_detach(struct hard_pairs *pairs, const struct pairlist *list,
                       const struct particles *particles);

#endif
