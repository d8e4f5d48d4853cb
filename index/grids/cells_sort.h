/* SPDX-License-Identifier: BSD-3-Clause */
/* The threaded sort of particles by cell; stable, and the same for any number of threads. Two passes: into
 * buckets of neighbouring cells (one histogram for each thread, so that no thread waits for another), then
 * every bucket by itself. For cells.c alone. */
#ifndef SCREE_INDEX_GRIDS_CELLS_SORT_H
#define SCREE_INDEX_GRIDS_CELLS_SORT_H

#include "index/grids/cells_table.h"

enum { CELLS_SPARSE_BITS = 21, CELLS_THREADED = 8192 }; /* one thread sorts fewer particles than this */

struct cells_sort_job {
    size_t count;
    double cells; /* number of cells of the dense grid */
    int threads;
};

void cells_scratch_reserve(struct cells_scratch *scratch, size_t count);

/* Sorts scratch->key[count] together with particle[count]. Dense: keys are cell numbers below job->cells, and
 * begin[cells + 1] gets the first slot of each cell; scratch->key is not kept. */
void cells_sort_dense(struct cells_scratch *scratch, const struct cells_sort_job *job, uint32_t *particle,
                      uint32_t *begin);

/* Any keys; scratch->key is sorted afterwards. */
void cells_sort_sparse(struct cells_scratch *scratch, const struct cells_sort_job *job, uint32_t *particle);

#endif
