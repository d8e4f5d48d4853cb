/* SPDX-License-Identifier: BSD-3-Clause */
/* Building a table, in three sweeps over the particles:
 *
 * 1. Keys: the cell of every particle. The sweep assumes that the particles are already in order (as after a
 * reorder), and writes their coordinates into the slots at the same time. If the assumption holds, only the
 * beginnings of the cells remain to be written.
 * 2. Otherwise the keys are sorted (cells_sort.c): by thread and bucket, then within each bucket.
 * 3. The coordinates are then gathered in the new order.
 *
 * If the order of the particles was made from the same grid, sweeps 1 and 2 are already done: cells_order
 * keeps the beginnings of the cells, and cells_fill only writes coordinates. */
#include "index/grids/cells.h"

#include "base/memory.h"
#include "index/grids/cells_slots.h"
#include "index/grids/cells_sort.h"

#include <string.h>

/* Computes the keys of a batch. */
static void put_keys(const struct cells_source *source, const struct located *located,
                     uint64_t *restrict key) {
    const uint32_t *x = located->cell[0], *y = located->cell[1], *z = located->cell[2];
    const uint32_t nx = (uint32_t)source->grid->n[0], ny = (uint32_t)source->grid->n[1];
    if (source->sparse) {
        for (size_t k = 0; k < located->count; k++) {
            key[k] = (uint64_t)z[k] << 2 * CELLS_SPARSE_BITS | (uint64_t)y[k] << CELLS_SPARSE_BITS | x[k];
        }
    } else { /* fewer than 2^31 cells */
        for (size_t k = 0; k < located->count; k++) {
            key[k] = (z[k] * ny + y[k]) * nx + x[k];
        }
    }
}

/* Sweep 1; without `coordinates` only the keys. */
static void find_keys(struct cells *cells, struct cells_scratch *scratch, const struct cells_source *source,
                      bool coordinates) {
    cells->in_order = true;
    cells_bounds_start(cells);
#pragma omp parallel num_threads(source->view->threads) if (cells->count > CELLS_THREADED)
    {
        struct cells_range range = cells_share(cells->count);
        struct cells mine = *cells;
        struct located located;
        uint64_t *key = scratch->key;
        bool ordered = true;
        for (size_t k = range.begin; k < range.end; k += located.count) {
            located.count = range.end - k < LOCATE_BATCH ? range.end - k : LOCATE_BATCH;
            cells_locate(&located, source, k);
            locate_cells(&located, source->grid);
            put_keys(source, &located, key + k);
            cells_slots_number(cells->particle + k, source, k, located.count);
            mine.clamped = mine.clamped || located.clamped;
            if (coordinates) {
                cells_slots_put(&mine, source->frame, k, &located);
            }
            for (size_t m = k > range.begin ? k : k + 1; m < k + located.count; m++) {
                ordered = ordered && key[m] >= key[m - 1];
            }
        }
#pragma omp barrier
        if (range.begin > 0 && range.begin < range.end) {
            ordered = ordered && key[range.begin - 1] <= key[range.begin];
        }
        cells_bounds_merge(cells, &mine, ordered);
    }
}

/* Cell beginnings from keys in order: each particle writes those of the cells after its predecessor's. */
static void dense_begins(struct cells *cells, const uint64_t *key, size_t all_cells, int threads) {
#pragma omp parallel num_threads(threads) if (cells->count > CELLS_THREADED)
    {
        struct cells_range range = cells_share(cells->count);
        for (size_t k = range.begin; k < range.end; k++) {
            uint64_t from = k > 0 ? key[k - 1] + 1 : 0;
            for (uint64_t c = from; c <= key[k]; c++) {
                cells->begin[c] = (uint32_t)k;
            }
        }
    }
    for (uint64_t c = cells->count > 0 ? key[cells->count - 1] + 1 : 0; c <= all_cells; c++) {
        cells->begin[c] = (uint32_t)cells->count;
    }
}

/* Pencils, their slices and x cells from keys in order. */
static void sparse_pencils(struct cells *cells, const uint64_t *key) {
    const uint64_t mask = ((uint64_t)1 << CELLS_SPARSE_BITS) - 1;
    size_t pencils = 0, occupied = 0;
    for (size_t k = 0; k < cells->count; k++) {
        pencils += k == 0 || key[k] >> CELLS_SPARSE_BITS != key[k - 1] >> CELLS_SPARSE_BITS;
        occupied += k == 0 || key[k] != key[k - 1];
    }
    cells->pencils = pencils;
    cells->occupied = occupied;
    size_t old = cells->pencil_capacity;
    cells->pencil = cells_ensure(cells->pencil, old, pencils, sizeof(uint64_t), "index pencils");
    cells->pencil_capacity = pencils > old ? pencils : old;
    size_t p = 0;
    for (size_t k = 0; k < cells->count; k++) {
        uint64_t row = key[k] >> CELLS_SPARSE_BITS;
        if (k == 0 || row != key[k - 1] >> CELLS_SPARSE_BITS) {
            cells->pencil[p] = (row & mask) | (row >> CELLS_SPARSE_BITS) << 32;
            cells->begin[p++] = (uint32_t)k;
        }
        cells->x_cell[k] = (uint32_t)(key[k] & mask);
    }
    cells->begin[p] = (uint32_t)cells->count;
    hash_start(&cells->by_key, pencils, "index hash");
    for (p = 0; p < pencils; p++) {
        hash_put(&cells->by_key, cells->pencil[p], (uint32_t)p);
    }
}

/* Makes room for all arrays and computes the keys. */
static void start(struct cells *cells, struct cells_scratch *scratch, const struct cells_source *source,
                  bool coordinates) {
    const struct members *members = source->members;
    cells->count = members->begin[source->group + 1] - members->begin[source->group];
    cells->sparse = source->sparse;
    cells->moved = false;
    cells_slots_reserve(cells, cells->count, coordinates);
    cells_scratch_reserve(scratch, cells->count);
    size_t begins = source->sparse ? cells->count + 1 : (size_t)source->grid->cells + 1;
    if (cells->begin_capacity > 4 * begins + 4096) {
        cells->begin_capacity = 0;
    }
    cells->begin = cells_ensure(cells->begin, cells->begin_capacity, begins, sizeof(uint32_t), "index cells");
    cells->begin_capacity = begins > cells->begin_capacity ? begins : cells->begin_capacity;
    find_keys(cells, scratch, source, coordinates);
}

static void sort(struct cells *cells, struct cells_scratch *scratch, const struct cells_source *source) {
    struct cells_sort_job job = {
        .count = cells->count, .cells = source->grid->cells, .threads = source->view->threads};
    if (source->sparse) {
        cells_sort_sparse(scratch, &job, cells->particle);
    } else {
        cells_sort_dense(scratch, &job, cells->particle, cells->begin);
    }
}

/* Fills the parts of the table beside the slots, from the keys in order. */
static void finish(struct cells *cells, const struct cells_scratch *scratch,
                   const struct cells_source *source) {
    if (cells->sparse) {
        size_t old = cells->x_cell_capacity;
        cells->x_cell = cells_ensure(cells->x_cell, old, cells->count, sizeof(uint32_t), "index x cells");
        cells->x_cell_capacity = cells->count > old ? cells->count : old;
        sparse_pencils(cells, scratch->key);
    } else if (cells->in_order) { /* else the sort wrote the beginnings */
        dense_begins(cells, scratch->key, (size_t)source->grid->cells, source->view->threads);
    }
}

void cells_build(struct cells *cells, struct cells_scratch *scratch, const struct cells_source *source,
                 uint32_t *slot_of) {
    start(cells, scratch, source, true);
    if (!cells->in_order) {
        sort(cells, scratch, source);
        cells_slots_gather(cells, source);
    }
    cells_slots_pad(cells);
    finish(cells, scratch, source);
    if (slot_of != NULL) {
        cells_slots_tell(cells, source->view->threads, slot_of);
    }
}

void cells_order(struct cells *cells, struct cells_scratch *scratch, const struct cells_source *source,
                 bool keep, uint32_t *order) {
    start(cells, scratch, source, false);
    if (!cells->in_order) {
        sort(cells, scratch, source);
    }
    if (keep) {
        finish(cells, scratch, source);
    }
    memcpy(order, cells->particle, cells->count * sizeof order[0]);
}

void cells_fill(struct cells *cells, const struct cells_source *source, uint32_t *slot_of) {
    cells_slots_reserve(cells, cells->count, true);
    cells_bounds_start(cells);
    cells->in_order = true;
#pragma omp parallel num_threads(source->view->threads) if (cells->count > CELLS_THREADED)
    {
        struct cells_range range = cells_share(cells->count);
        struct cells mine = *cells;
        struct located located;
        for (size_t k = range.begin; k < range.end; k += located.count) {
            located.count = range.end - k < LOCATE_BATCH ? range.end - k : LOCATE_BATCH;
            cells_locate(&located, source, k);
            mine.clamped = mine.clamped || located.clamped;
            cells_slots_put(&mine, source->frame, k, &located);
            cells_slots_number(cells->particle + k, source, k, located.count);
        }
        /* the merge begins when every thread has its copy of the bounds */
#pragma omp barrier
        cells_bounds_merge(cells, &mine, true);
    }
    cells_slots_pad(cells);
    cells_slots_tell(cells, source->view->threads, slot_of);
}

void cells_free(struct cells *cells) {
    memory_free(cells->x);
    memory_free(cells->y);
    memory_free(cells->z);
    memory_free(cells->r);
    for (int d = 0; d < 3; d++) {
        memory_free(cells->origin[d]);
    }
    memory_free(cells->particle);
    memory_free(cells->begin);
    memory_free(cells->pencil);
    memory_free(cells->x_cell);
    hash_free(&cells->by_key);
    *cells = (struct cells){0};
}

size_t cells_memory(const struct cells *cells) {
    return cells->capacity * sizeof(uint32_t) +
           (cells->place_capacity * 4 + cells->origin_capacity * 3) * sizeof(float) +
           (cells->x_cell_capacity + cells->begin_capacity) * sizeof(uint32_t) +
           cells->pencil_capacity * sizeof(uint64_t) + hash_memory(&cells->by_key);
}
