/* SPDX-License-Identifier: BSD-3-Clause */
/* The search of a range of rows, written once for all instruction sets: a file that includes this one has
 * included a lanes_*.h before.
 *
 * Rows are taken in blocks: up to ROWS consecutive particles of one class in consecutive slots (or nearly) of
 * one pencil, as they lie in memory after a reorder. In a dense table of its own grid each row searches by
 * itself (search_direct.h). So does each row that searches smaller particles, unless its window is so wide
 * that the search should leave out the pencils at the corners. A span of rows searches any other table
 * together: the whole block; OWN_ROWS rows in their own table; one row in a table of smaller particles. The
 * candidates of the whole span are copied to a small buffer, shifted by their image, and every row is tested
 * against the buffer, eight or sixteen candidates at a time. So cells are looked up once a span, no image
 * appears in the inner loop, and that loop has no short runs. If rows lie in any other order, blocks are
 * single rows: correct, but slower.
 *
 * The filter is in single precision and loses nothing (frame.h): distances that are possible but not certain
 * are decided by the exact test.
 *
 * Within one table of owned particles a pair is kept by the row in the *earlier slot*, for any image: so
 * exactly one of (i, j, image) and (j, i, opposite image) is kept. In the buffer the candidates of the row's
 * own pencil come first, beginning behind the span's first slot, so that a row skips as many candidates as
 * its slot lies behind that first slot. Slices of an image that hold slots of the span itself would break
 * this order. This happens in thin boxes; the rows are then searched one by one. */
#ifndef SCREE_INDEX_SEARCH_SEARCH_ROWS_H
#define SCREE_INDEX_SEARCH_SEARCH_ROWS_H

#include "index/search/search_direct.h"

#include <string.h>

/* Selects the rows from ... to - 1 of the block. */
LANES_INLINE void span_set(struct quest *quest, int from, int to) {
    const struct block *block = &quest->block;
    const struct grid *grid = &quest->levels->level[quest->levels->plan.grid_of[block->size_class]].grid;
    struct span *span = &quest->span;
    span->from = from;
    span->to = to;
    span->first_slot = block->slot[from];
    for (int d = 0; d < 3; d++) {
        float low = block->x[d][from], high = low;
        for (int k = from; k < to; k++) {
            float x = block->x[d][k];
            low = x < low ? x : low;
            high = x > high ? x : high;
        }
        span->low[d] = low;
        span->high[d] = high;
        span->own_low[d] = grid_cell(grid, d, low);
        span->own_high[d] = grid_cell(grid, d, high);
    }
    float r_max = block->r[from];
    for (int k = from; k < to; k++) {
        r_max = block->r[k] > r_max ? block->r[k] : r_max;
    }
    span->r_max = r_max;
}

/* Radii and coordinates of the rows from their slots; those behind the last row are a row's, too, as windows are made
 * for whole vectors. */
LANES_INLINE void block_load(struct block *block, const struct cells *cells) {
    const int n = block->rows;
    const uint32_t first = block->slot[0];
    if (block->slot[n - 1] - first == (uint32_t)n - 1 && first + (size_t)ROWS <= cells->count) {
        memcpy(block->x[0], cells->x + first, sizeof block->r);
        memcpy(block->x[1], cells->y + first, sizeof block->r);
        memcpy(block->x[2], cells->z + first, sizeof block->r);
        memcpy(block->r, cells->r + first, sizeof block->r);
        return;
    }
    for (int k = 0; k < rows_whole(n); k++) {
        uint32_t slot = block->slot[k < n ? k : n - 1];
        block->x[0][k] = cells->x[slot];
        block->x[1][k] = cells->y[slot];
        block->x[2][k] = cells->z[slot];
        block->r[k] = cells->r[slot];
    }
}

/* The pencil of a slot of a dense table, sought from `near` on, where it mostly is. */
LANES_INLINE size_t pencil_of(const struct cells *cells, const struct grid *grid, uint32_t slot,
                              size_t near) {
    const size_t nx = (size_t)grid->n[0];
    size_t low = 0, high = (size_t)grid->n[1] * (size_t)grid->n[2];
    for (size_t p = near; p < near + 4 && p < high && cells->begin[p * nx] <= slot; p++) {
        if (slot < cells->begin[(p + 1) * nx]) {
            return p;
        }
    }
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (cells->begin[middle * nx] <= slot) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

/* The end of the slots that may share a block with this one; finds the block's pencil in a table that has any. */
LANES_INLINE uint32_t block_end(struct quest *quest, const struct level *level, uint32_t slot) {
    const struct cells *cells = &level->owned;
    const struct grid *grid = &level->grid;
    const uint32_t limit = slot + SLOTS_APART;
    uint32_t end;
    if (quest->levels->plan.stencils || cells->sparse) {
        const int cell[3] = {grid_cell(grid, 0, cells->x[slot]), grid_cell(grid, 1, cells->y[slot]),
                             grid_cell(grid, 2, cells->z[slot])};
        int last = quest->levels->plan.stencils ? cell[0] : grid->n[0] - 1;
        end = cells_run(cells, grid, cell[0], last, cell[1], cell[2]).end;
    } else {
        quest->block.pencil = pencil_of(cells, grid, slot, quest->block.pencil);
        end = cells->begin[(quest->block.pencil + 1) * (size_t)grid->n[0]];
    }
    return end < limit ? end : limit;
}

/* Makes the block that begins with particle i and does not reach `last`; returns the particle after it. */
LANES_INLINE size_t next_block(struct quest *quest, size_t i, size_t last) {
    const uint32_t *slot_of = quest->levels->slot_of;
    const uint8_t *size_class = quest->view->size_class;
    struct block *block = &quest->block;
    block->size_class = size_class[i];
    const struct level *level = &quest->levels->level[quest->levels->plan.grid_of[block->size_class]];
    const uint32_t end = block_end(quest, level, slot_of[i]);
    const int most = last - i < ROWS ? (int)(last - i) : ROWS;
    int rows = 0;
    do {
        block->particle[rows] = (uint32_t)i;
        block->slot[rows] = slot_of[i];
        rows++, i++;
    } while (rows < most && size_class[i] == block->size_class && slot_of[i] > block->slot[rows - 1] &&
             slot_of[i] < end); /* particles of a class without cells have no slot */
    block->rows = rows;
    block_load(block, &level->owned);
    return i;
}

/* The present search for the rows from ... to - 1. */
LANES_INLINE void search_span(struct quest *quest, int from, int to) {
    span_set(quest, from, to);
    if (gather(quest)) {
        flush(quest);
        return;
    }
    for (int k = from; k < to; k++) {
        span_set(quest, k, k + 1);
        gather(quest);
        flush(quest);
    }
}

/* The present search, which is `direct`, for all rows of the block. */
LANES_INLINE void search_direct(struct quest *quest) {
    struct windows windows;
    windows_make(quest, &windows);
    direct_rows(quest, &windows);
}

LANES_INLINE void search_rows(const struct levels *levels, const struct searches *searches,
                              const struct index_view *view, size_t first, size_t last,
                              struct index_sink *sink) {
    struct quest quest;
    quest.levels = levels;
    quest.view = view;
    quest.sink = *sink;
    quest.block.pencil = 0;
    for (size_t i = first; i < last;) {
        if (searches->count[view->size_class[i]] == 0) {
            i = members_run(view->size_class, i, last);
            continue;
        }
        i = next_block(&quest, i, last);
        int c = quest.block.size_class;
        for (int s = 0; s < searches->count[c]; s++) {
            quest.search = &searches->list[c][s];
            SEARCH_EVENT(quest.search->single ? COST_SINGLE : COST_VISIT,
                         quest.search->single || !quest.search->direct ? quest.block.rows : 0);
            if (quest.search->direct) {
                search_direct(&quest);
                continue;
            }
            int step = quest.search->half ? OWN_ROWS : quest.search->single ? 1 : ROWS;
            for (int from = 0; from < quest.block.rows; from += step) {
                search_span(&quest, from, from + step < quest.block.rows ? from + step : quest.block.rows);
            }
        }
    }
    sink->count = quest.sink.count;
}

#endif
