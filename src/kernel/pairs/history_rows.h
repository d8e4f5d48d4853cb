/* SPDX-License-Identifier: BSD-3-Clause */
/* The memory of contacts as rows, which go with their particles over a rebuild and into checkpoints: of pairs, of contacts
 * with walls, and what a physics remembers of pairs. Owned particle k, in the present order, carries the rows start[k] ...
 * start[k + 1] - 1. */
#ifndef SCREE_PAIRS_HISTORY_ROWS_H
#define SCREE_PAIRS_HISTORY_ROWS_H

#include <stddef.h>
#include <stdint.h>

/* HISTORY_COMPONENTS_USUAL: of a law without parts (physics/grains/laws/law_parts.h); rows on the wire and in checkpoints
 * have as many at least. */
enum { HISTORY_COMPONENTS_USUAL = 6, HISTORY_COMPONENTS_MAX = 12 };

/* A record on the move: between detach and attach. */
struct history_row {
    int64_t id, partner;  /* the particle that carries it; the other one, or (below 0) what its owner says */
    double separation[3]; /* of a pair: x_higher - x_lower when detached, tells images apart */
    double value[HISTORY_COMPONENTS_MAX]; /* of a pair: oriented from the lower id to the higher */
};

struct history_rows {
    size_t *start; /* owned + 1 entries; NULL: no rows, and nothing is done with them */
    struct history_row *row;
    size_t count;
    int components; /* doubles of a row that count */
};

/* The first bytes of a row that matter where records have so many doubles: as many travel. */
static inline size_t history_row_bytes(int components) {
    int sent = components > HISTORY_COMPONENTS_USUAL ? components : HISTORY_COMPONENTS_USUAL;
    return offsetof(struct history_row, value) + (size_t)sent * sizeof(double);
}

/* Follows particles_reorder with the same order; and particles_remove with the same flags (ghosts == 0, before the
 * particles change). */
void history_rows_reorder(struct history_rows *rows, const uint32_t *order, size_t owned);
void history_rows_remove(struct history_rows *rows, const uint8_t *remove, size_t owned);

/* Follows particles that are appended: there were `before`, now there are `after`. The new ones have no rows. */
void history_rows_extend(struct history_rows *rows, size_t before, size_t after);

void history_rows_free(struct history_rows *rows);

#endif
