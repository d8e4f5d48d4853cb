/* SPDX-License-Identifier: BSD-3-Clause */
/* The memory of contacts (the tangential spring, the rolling spring, numbers that a law with parts adds),
 * compact: one record a *contact*, none for pairs that are out of its law's range.
 *
 * Between rebuilds a record belongs to a pair of the list. Each thread keeps its records in the order of its
 * pairs: arrays `pair` (number of the pair in the list, increasing) and `value` (components doubles a
 * record). The force loop walks pairs in list order, finds the old record with a merge pointer, and writes
 * the records of the contacts of this step into the other of two buffers; then the buffers change places
 * (history_flip). Both sides of a one-sided pair keep a record.
 *
 * Over a rebuild a record is keyed by the two global ids and oriented from the lower id to the higher (the
 * spring vector of (j, i) is minus that of (i, j); numbers are the same for both): history_detach turns list records into rows by particle,
 * which travel with migrating and reordered particles; history_attach hands them to the pairs of the new
 * list. Two images of the same two particles are told apart by their separation, which a rebuild does not
 * change. */
#ifndef SCREE_PAIRS_HISTORY_H
#define SCREE_PAIRS_HISTORY_H

#include "kernel/pairs/history_rows.h"
#include "kernel/pairs/pairlist.h"

/* The records of one thread, in one of the two buffers. */
struct history_part {
    size_t count, capacity; /* once there are records, HISTORY_PAD more are allocated */
    uint32_t *pair;         /* pair number - first pair of the thread; increasing */
    double *value;          /* components doubles a record, oriented from row to partner */
};

/* Records behind the last that may be read and written: the force loop moves several together. */
enum { HISTORY_PAD = 4 };

struct history {
    int components; /* doubles a record: 3 tangential spring [+ 3 rolling spring] [+ numbers] */
    int odd;        /* the first so many change sign with the order of the pair: vectors */
    int threads;
    int now;                      /* buffer that holds the records of the last force evaluation */
    struct history_part *part[2]; /* [buffer][thread] */
};

/* All components are odd until the caller sets `odd`. */
struct history *history_create(int components, int threads);
void history_destroy(struct history **history);

/* Makes room for `contacts` records in the buffer that is written next, of thread t. Called by the thread
 * itself, before the loop. */
void history_reserve(struct history *history, int thread, size_t contacts);

/* Makes room for `contacts` records in a part, and keeps those that it has. */
void history_part_reserve(struct history_part *part, int components, size_t contacts);

/* The records of the last evaluation, those of the thread whose pairs begin with number `first` of the list; NULL: there are
 * none. */
const struct history_part *history_part_of(const struct history *history, const struct pairlist *list,
                                           size_t first);

/* The record of a pair, a number less the thread's first; NULL: it has none. */
const double *history_record(const struct history *history, const struct history_part *part, uint32_t pair);

/* Exchanges the two buffers: the written one becomes `now`. One thread. */
void history_flip(struct history *history);

/* Turns the records of the list into rows of the owned particles (before migration and reorder; the list and
 * the particles still belong together). A record lies with its row particle; if `both_ends`, also with its
 * partner where that is owned, as it must be when one end may leave this rank. Allocates into `rows`;
 * history_rows_free releases. */
void history_detach(const struct history *history, const struct pairlist *list,
                    const struct particles *particles, bool both_ends, struct history_rows *rows);

/* Rows in any order, each with the owned particle that carries it. Without their separations. */
struct history_loose {
    uint32_t *carrier;
    struct history_row *row;
    size_t count;
};

/* Turns the records of pairs with a copy, or with a particle whose place is PARTICLE_LEFT (`place` has owned
 * entries), into rows of their owned ends: history_keep is for the other records. Rows of the particles that
 * leave go to `leave`, carried by their present numbers; rows of the others go to `stay`, carried by their
 * places. Allocates into both; history_loose_free releases. Opens its own thread team. */
void history_loosen(const struct history *history, const struct pairlist *list,
                    const struct particles *particles, const uint32_t *place, struct history_loose *stay,
                    struct history_loose *leave);

/* Moves the rows of `more` behind those of `loose`, and frees `more`. */
void history_loose_join(struct history_loose *loose, struct history_loose *more);
void history_loose_free(struct history_loose *loose);

/* Hands the rows to the pairs of the new list (after the rebuild); rows of pairs that are no longer in the
 * list are dropped. If two particles can meet through several images, a row belongs to the pair whose
 * separation is that of the row; images are at least `apart` from each other (the shortest periodic edge).
 * INFINITY promises that there are no such pairs (every periodic edge is longer than two cut-offs), which
 * spares comparing. Opens its own thread team. */
void history_attach(struct history *history, const struct history_rows *rows, const struct pairlist *list,
                    const struct particles *particles, double apart);

/* Bytes held. */
size_t history_memory(const struct history *history);

#endif
