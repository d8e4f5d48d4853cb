/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of any size that go with their particles over a rebuild: what a particle remembers of others. Owned particle k,
 * in the present order, carries the rows start[k] ... start[k + 1] - 1. */
#ifndef SCREE_PAIRS_ROWSET_H
#define SCREE_PAIRS_ROWSET_H

#include <stddef.h>
#include <stdint.h>

struct rowset {
    size_t *start; /* owned + 1 entries; NULL: no rows */
    void *row;
    size_t count, bytes; /* number of rows; bytes of each */
    size_t sent;         /* the first bytes of a row, which travel to other ranks */
};

/* Follows particles_reorder with the same order; and particles_remove with the same flags (before the particles
 * change). Without rows nothing is done. */
void rowset_reorder(struct rowset *rows, const uint32_t *order, size_t owned);
void rowset_remove(struct rowset *rows, const uint8_t *remove, size_t owned);

/* Follows particles that are appended: there were `before`, now there are `after`. The new ones have no rows. Returns
 * the new starts; NULL stays NULL. */
size_t *rowset_extend(size_t *start, size_t before, size_t after);

void rowset_free(struct rowset *rows);

#endif
