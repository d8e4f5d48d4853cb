/* SPDX-License-Identifier: BSD-3-Clause */
/* The functions of a table of particles in cell order (cells_table.h). */
#ifndef SCREE_INDEX_GRIDS_CELLS_H
#define SCREE_INDEX_GRIDS_CELLS_H

#include "index/grids/cells_table.h"

/* Builds the table; slot_of[particle] is set for all its particles unless slot_of is NULL. Opens teams of
 * threads. The result depends on the particles alone, not on the number of threads. */
void cells_build(struct cells *cells, struct cells_scratch *scratch, const struct cells_source *source,
                 uint32_t *slot_of);

/* Writes the particle numbers of the group in cell order to order[]. `cells` serves as scratch; with `keep`
 * `cells` becomes a table without coordinates: cells_fill adds them once the particles lie in that order.
 * Opens teams of threads. */
void cells_order(struct cells *cells, struct cells_scratch *scratch, const struct cells_source *source,
                 bool keep, uint32_t *order);

/* As cells_build, for the table that cells_order kept: the particle at place k of the group is the former
 * particle order[k], and no particle has moved. */
void cells_fill(struct cells *cells, const struct cells_source *source, uint32_t *slot_of);

/* New coordinates and radii for a table whose particles lie in the order of the slots: they have moved, and stay in
 * their slots and cells. turn[particle] becomes the code of the image in which the particle is nearest to its cell;
 * the result is true if one of them is not 0. Opens a team of threads. */
bool cells_follow(struct cells *cells, const struct cells_source *source, uint8_t *turn);

void cells_free(struct cells *cells);
void cells_scratch_free(struct cells_scratch *scratch);

/* Bytes held. */
size_t cells_memory(const struct cells *cells);
size_t cells_scratch_memory(const struct cells_scratch *scratch);

/* The pencil number of (y, z) in a sparse table, or -1. */
static inline int64_t cells_find_pencil(const struct cells *cells, int y, int z) {
    uint64_t key = (uint64_t)(uint32_t)y | (uint64_t)(uint32_t)z << 32;
    for (uint32_t p = hash_first(&cells->by_key, key); p != HASH_END; p = cells->by_key.next[p]) {
        if (cells->pencil[p] == key) {
            return p;
        }
    }
    return -1;
}

/* The first slot of sparse pencil p whose x cell is at least x. */
static inline uint32_t cells_bisect(const struct cells *cells, int64_t p, int x) {
    uint32_t low = cells->begin[p], high = cells->begin[p + 1];
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (cells->x_cell[middle] < (uint32_t)x) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

struct cells_slice {
    uint32_t begin, end;
};

/* The slots in the cells (x0 ... x1, y, z), ends included. */
static inline struct cells_slice cells_run(const struct cells *cells, const struct grid *grid, int x0, int x1,
                                           int y, int z) {
    if (!cells->sparse) {
        const uint32_t *begin =
            cells->begin + ((size_t)z * (size_t)grid->n[1] + (size_t)y) * (size_t)grid->n[0];
        return (struct cells_slice){begin[x0], begin[x1 + 1]};
    }
    int64_t p = cells_find_pencil(cells, y, z);
    if (p < 0) {
        return (struct cells_slice){0, 0};
    }
    return (struct cells_slice){cells_bisect(cells, p, x0), cells_bisect(cells, p, x1 + 1)};
}

#endif
