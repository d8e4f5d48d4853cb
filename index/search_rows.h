/* The search of a range of rows, written once for all instruction sets: a file that includes this one has
 * included a lanes_*.h before.
 *
 * Rows are taken in blocks: up to ROWS consecutive particles of one class in consecutive slots (or nearly) of
 * one pencil, as they lie in memory after a reorder. A search takes a span of them at once, the whole block,
 * or OWN_ROWS where the rows' own table is searched, which is dense. The candidates of the whole span are
 * copied to a small buffer, shifted by their image, and every row is tested against it, eight or
 * sixteen candidates at a time. So cells are looked up once a span, no image appears in the inner loop, and
 * that loop has no short runs. Where rows lie in any other order, blocks are single rows: as right, only
 * slower.
 *
 * The filter is in single precision and loses nothing (frame.h): distances that are possible but not certain
 * are decided by the exact test.
 *
 * Within one table of owned particles a pair is kept by the row in the *earlier slot*, whatever the image: of
 * (i, j, image) and (j, i, opposite image) exactly one is. In the buffer the candidates of the row's own
 * pencil come first, beginning behind the span's first slot, so that a row skips as many as its slot is
 * later. Slices of an image that hold slots of the span itself would break that; then the box is thin, and
 * rows go one by one. */
#ifndef SCREE_INDEX_SEARCH_ROWS_H
#define SCREE_INDEX_SEARCH_ROWS_H

#include "index/search_gather.h"

/* Selects the rows from ... to - 1 of the block. */
LANES_INLINE void span_set(struct quest *quest, int from, int to) {
    const struct block *block = &quest->block;
    const struct grid *grid = &quest->levels->level[quest->levels->plan.grid_of[block->size_class]].grid;
    struct span *span = &quest->span;
    span->from = from;
    span->to = to;
    span->first_slot = block->slot[from];
    span->r_max = block->r[from];
    for (int d = 0; d < 3; d++) {
        span->low[d] = span->high[d] = block->x[from][d];
    }
    for (int k = from + 1; k < to; k++) {
        for (int d = 0; d < 3; d++) {
            float x = block->x[k][d];
            span->low[d] = x < span->low[d] ? x : span->low[d];
            span->high[d] = x > span->high[d] ? x : span->high[d];
        }
        span->r_max = block->r[k] > span->r_max ? block->r[k] : span->r_max;
    }
    for (int d = 0; d < 3; d++) {
        span->own_low[d] = grid_cell(grid, d, span->low[d]);
        span->own_high[d] = grid_cell(grid, d, span->high[d]);
    }
}

/* Puts owned particle i, which has this slot, into row k of the block. */
LANES_INLINE void block_row(struct block *block, const struct cells *cells, int k, uint32_t i,
                            uint32_t slot) {
    block->particle[k] = i;
    block->slot[k] = slot;
    block->r[k] = cells->r[slot];
    block->x[k][0] = cells->x[slot];
    block->x[k][1] = cells->y[slot];
    block->x[k][2] = cells->z[slot];
}

/* The end of the slots that may share a block with the first row. */
LANES_INLINE uint32_t block_end(const struct quest *quest, const struct level *level) {
    int cell[3];
    for (int d = 0; d < 3; d++) {
        cell[d] = grid_cell(&level->grid, d, quest->block.x[0][d]);
    }
    int last = quest->levels->plan.stencils ? cell[0] : level->grid.n[0] - 1;
    uint32_t end = cells_run(&level->owned, &level->grid, cell[0], last, cell[1], cell[2]).end;
    uint32_t limit = quest->block.slot[0] + SLOTS_APART;
    return end < limit ? end : limit;
}

/* Makes the block that begins with particle i and does not reach `last`; returns the particle after it. */
LANES_INLINE size_t next_block(struct quest *quest, size_t i, size_t last) {
    const uint32_t *slot_of = quest->levels->slot_of;
    const uint8_t *size_class = quest->view->size_class;
    struct block *block = &quest->block;
    block->size_class = size_class[i];
    const struct level *level = &quest->levels->level[quest->levels->plan.grid_of[block->size_class]];
    block_row(block, &level->owned, 0, (uint32_t)i, slot_of[i]);
    uint32_t end = block_end(quest, level);
    block->rows = 1;
    for (i++; i < last && block->rows < ROWS && size_class[i] == block->size_class; i++) {
        uint32_t slot = slot_of[i];
        if (slot <= block->slot[block->rows - 1] || slot >= end) {
            break;
        }
        block_row(block, &level->owned, block->rows, (uint32_t)i, slot);
        block->rows++;
    }
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

LANES_INLINE void search_rows(const struct levels *levels, const struct index_view *view, size_t first,
                              size_t last, struct index_sink *sink) {
    struct quest quest;
    quest.levels = levels;
    quest.view = view;
    quest.sink = *sink;
    for (size_t i = first; i < last;) {
        i = next_block(&quest, i, last);
        int c = quest.block.size_class;
        for (int s = 0; s < levels->searches[c]; s++) {
            quest.search = &levels->search[c][s];
            int step = quest.search->half ? OWN_ROWS : ROWS;
            for (int from = 0; from < quest.block.rows; from += step) {
                search_span(&quest, from, from + step < quest.block.rows ? from + step : quest.block.rows);
            }
        }
    }
    sink->count = quest.sink.count;
}

#endif
