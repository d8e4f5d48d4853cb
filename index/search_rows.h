/* The search of a range of rows, written once for all instruction sets: a file that includes this one has
 * included a lanes_*.h before.
 *
 * Rows are taken in blocks: up to ROWS consecutive particles of one class in consecutive slots (or nearly) of
 * one pencil, as they lie in memory after a reorder. A search takes a span of them at once, the whole block,
 * or OWN_ROWS where the rows' own table is searched, which is dense. The candidates of the whole span are
 * copied to a small buffer, shifted by their image, and every row is tested against it, eight candidates at a
 * time. So cells are looked up once a span, no image appears in the inner loop, and that loop has no short
 * runs. Where rows lie in any other order, blocks are single rows: as right, only slower.
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

#include "index/exact.h"
#include "index/search.h"

#include <math.h>

enum { ROWS = 32, OWN_ROWS = 12, SLOTS_APART = 128, CANDIDATES = 512 };

struct block {
    int rows;
    int size_class;
    uint32_t particle[ROWS], slot[ROWS];
    float x[ROWS][3], r[ROWS];
};

/* The rows from ... to - 1 of the block, which are searched together. */
struct span {
    int from, to;
    uint32_t first_slot;
    float low[3], high[3], r_max;
    int own_low[3], own_high[3]; /* their cells in their own grid */
};

struct candidates {
    size_t count;
    bool continued; /* part of the search's candidates went through the buffer before */
    float x[CANDIDATES + 2 * LANES], y[CANDIDATES + 2 * LANES], z[CANDIDATES + 2 * LANES];
    float r[CANDIDATES + 2 * LANES];
    uint32_t j[CANDIDATES + 2 * LANES];
};

struct quest {
    const struct levels *levels;
    const struct index_view *view;
    const struct search *search;
    struct block block;
    struct span span;
    struct candidates buffer;
    struct index_sink sink;
};

/* The parts of the box (three at most) that a window meets in one direction: an image, and cells. */
struct window {
    int parts;
    int image[3], first[3], last[3];
    float shift[3]; /* added to candidates, frame unit */
};

/* Of the possible but not certain candidates at `at`, those that are pairs. */
LANES_INLINE unsigned decide(const struct quest *quest, uint32_t i, size_t at, unsigned doubtful) {
    unsigned kept = 0;
    for (unsigned rest = doubtful; rest != 0; rest &= rest - 1) {
        unsigned k = (unsigned)__builtin_ctz(rest);
        uint32_t tagged = quest->buffer.j[at + k];
        uint32_t j = tagged & (((uint32_t)1 << INDEX_IMAGE_SHIFT) - 1);
        int image[3];
        exact_image(tagged >> INDEX_IMAGE_SHIFT, image);
        bool keep =
            exact_near(quest->view, i, j, image) && (!quest->search->home || exact_home(quest->view, i, j));
        kept |= (unsigned)keep << k;
    }
    return kept;
}

/* Emits the possible partners among the candidates from `at` on. True if some are not certain: then, if
 * `exact`, they were decided, else they were all emitted. */
LANES_INLINE bool emit_row(struct quest *quest, const struct lanes_row *row, uint32_t i, size_t at,
                           bool exact) {
    const struct candidates *buffer = &quest->buffer;
    struct index_sink sink = quest->sink;
    unsigned doubtful = 0;
    for (; at < buffer->count; at += LANES) {
        unsigned doubt;
        unsigned chosen =
            lanes_test(row, buffer->x + at, buffer->y + at, buffer->z + at, buffer->r + at, &doubt);
        doubtful |= doubt;
        if (exact && doubt != 0) {
            chosen ^= doubt ^ decide(quest, i, at, doubt);
        }
        if (sink.count < sink.capacity) {
            sink.count += lanes_put(sink.i + sink.count, sink.j + sink.count, i, buffer->j + at, chosen);
        } else {
            sink.count += (unsigned)__builtin_popcount(chosen);
        }
    }
    quest->sink.count = sink.count;
    return doubtful != 0;
}

/* The rare second attempt for a row with doubtful candidates, out of the way of the fast one. */
static LANES_TARGET __attribute__((noinline)) void
emit_row_exactly(struct quest *quest, const struct lanes_row *row, uint32_t i, size_t at) {
    emit_row(quest, row, i, at, true);
}

/* Tests row k of the block against the buffer. */
LANES_INLINE void test_row(struct quest *quest, int k) {
    const struct block *block = &quest->block;
    const struct search *search = quest->search;
    uint32_t i = block->particle[k];
    struct lanes_row row = lanes_row(block->x[k], block->r[k] + search->margin, search->certain);
    size_t at = search->half && !quest->buffer.continued ? block->slot[k] - quest->span.first_slot : 0;
    size_t count = quest->sink.count;
    if (emit_row(quest, &row, i, at, false)) {
        quest->sink.count = count;
        emit_row_exactly(quest, &row, i, at);
    }
}

/* Tests all rows against the buffer and empties it. */
LANES_INLINE void flush(struct quest *quest) {
    struct candidates *buffer = &quest->buffer;
    if (buffer->count > 0) {
        for (size_t k = buffer->count; k < buffer->count + LANES; k++) {
            buffer->x[k] = buffer->y[k] = buffer->z[k] = 1e30f; /* too far for everybody */
            buffer->r[k] = 0;
        }
        for (int k = quest->span.from; k < quest->span.to; k++) {
            test_row(quest, k);
        }
    }
    buffer->count = 0;
    buffer->continued = true;
}

/* Adds a slice of slots to the candidates. */
LANES_INLINE void append(struct quest *quest, struct cells_slice slice, const float shift[3], uint32_t bits) {
    const struct cells *cells = quest->search->cells;
    struct candidates *buffer = &quest->buffer;
    uint32_t from = slice.begin;
    if (quest->search->half && from <= quest->span.first_slot) {
        from = quest->span.first_slot + 1;
    }
    while (from < slice.end) {
        if (buffer->count == CANDIDATES) {
            flush(quest);
        }
        size_t at = buffer->count;
        uint32_t room = (uint32_t)(CANDIDATES - at);
        uint32_t take = slice.end - from < room ? slice.end - from : room;
        for (uint32_t k = 0; k < take; k += LANES) {
            lanes_copy(buffer->x + at + k, cells->x + from + k, shift[0]);
            lanes_copy(buffer->y + at + k, cells->y + from + k, shift[1]);
            lanes_copy(buffer->z + at + k, cells->z + from + k, shift[2]);
            lanes_copy(buffer->r + at + k, cells->r + from + k, 0);
            lanes_copy_tagged(buffer->j + at + k, cells->particle + from + k, bits);
        }
        buffer->count += take;
        from += take;
    }
}

LANES_INLINE uint32_t image_bits(int sx, int sy, int sz) {
    return (sx | sy | sz) == 0 ? 0 : index_image_code(sx, sy, sz) << INDEX_IMAGE_SHIFT;
}

/* The window [low, high] in direction d. The unshifted box comes first. */
LANES_INLINE struct window window_of(const struct frame *frame, const struct grid *grid, int d, float low,
                                     float high) {
    struct window window = {.parts = 1};
    window.first[0] = grid_cell(grid, d, low);
    window.last[0] = grid_cell(grid, d, high);
    if (!frame->periodic[d] || (low > frame->all_low[d] + frame->tolerance * 4 &&
                                high < frame->all_high[d] - frame->tolerance * 4)) {
        return window;
    }
    float edge = frame->edge[d];
    float slack = edge * 0x1p-18f + 4 * frame->tolerance;
    for (int s = -1; s <= 1; s += 2) {
        float from = low - (float)s * edge, to = high - (float)s * edge;
        if (to >= frame->all_low[d] - slack && from <= frame->all_high[d] + slack) {
            int p = window.parts++;
            window.image[p] = s;
            window.shift[p] = (float)s * edge;
            window.first[p] = grid_cell(grid, d, from);
            window.last[p] = grid_cell(grid, d, to);
        }
    }
    return window;
}

/* True if an image of the box meets the span's own cells: see the head of this file. */
LANES_INLINE bool window_returns(const struct window *window, int own_low, int own_high) {
    for (int p = 1; p < window->parts; p++) {
        if (window->first[p] <= own_high && window->last[p] >= own_low) {
            return true;
        }
    }
    return false;
}

/* What remains of the reach in x for the pencil (y, z), or -1: beyond it. low and high bound the rows. */
LANES_INLINE float reach_left(const struct grid *grid, const int cell[3], const float low[3],
                              const float high[3], float reach) {
    float rest = reach * reach;
    for (int d = 1; d < 3; d++) {
        float slack = grid->size[d] * (1e-3f + (float)grid->n[d] * 0x1p-20f);
        float from = grid->anchor[d] + (grid->base[d] + (float)cell[d]) * grid->size[d] - slack;
        float to = from + grid->size[d] + 2 * slack;
        float gap = from - high[d] > low[d] - to ? from - high[d] : low[d] - to;
        rest -= gap > 0 ? gap * gap : 0;
    }
    return rest < 0 ? -1 : sqrtf(rest) * (1 + 0x1p-18f);
}

/* One part of the box: cells first ... last in each direction, seen from rows at low ... high. */
struct part {
    int first[3], last[3];
    float low[3], high[3], shift[3];
    float reach;
    uint32_t bits;
    bool round; /* leave out pencils beyond the reach */
};

/* The run of part's cells in pencil (y, z). */
LANES_INLINE void append_pencil(struct quest *quest, const struct part *part, int y, int z) {
    const struct grid *grid = &quest->search->level->grid;
    int x0 = part->first[0], x1 = part->last[0];
    if (part->round) {
        float left = reach_left(grid, (const int[3]){0, y, z}, part->low, part->high, part->reach);
        if (left < 0) {
            return;
        }
        x0 = grid_cell(grid, 0, part->low[0] - left);
        x1 = grid_cell(grid, 0, part->high[0] + left);
    }
    append(quest, cells_run(quest->search->cells, grid, x0, x1, y, z), part->shift, part->bits);
}

/* A sparse table with fewer pencils than the part: go through its pencils. Before pencil `start` nothing is
 * new. */
LANES_INLINE void append_all_pencils(struct quest *quest, const struct part *part, size_t start) {
    const struct cells *cells = quest->search->cells;
    for (size_t p = start; p < cells->pencils; p++) {
        int y = (int)(uint32_t)cells->pencil[p], z = (int)(cells->pencil[p] >> 32);
        if (y < part->first[1] || y > part->last[1] || z < part->first[2] || z > part->last[2]) {
            continue;
        }
        struct cells_slice slice = {cells_bisect(cells, (int64_t)p, part->first[0]),
                                    cells_bisect(cells, (int64_t)p, part->last[0] + 1)};
        append(quest, slice, part->shift, part->bits);
    }
}

LANES_INLINE bool empty_rows(const struct cells *cells, const struct grid *grid, int y0, int y1, int z) {
    size_t row = (size_t)z * (size_t)grid->n[1], n = (size_t)grid->n[0];
    return !cells->sparse && cells->begin[(row + (size_t)y0) * n] == cells->begin[(row + (size_t)y1 + 1) * n];
}

/* All pencils of a part; with `own` only from the block's own one on, that one first. */
LANES_INLINE void append_part(struct quest *quest, const struct part *part, bool own) {
    const struct cells *cells = quest->search->cells;
    const struct grid *grid = &quest->search->level->grid;
    int own_y = quest->span.own_low[1], own_z = quest->span.own_low[2];
    size_t pencils =
        (size_t)(part->last[1] - part->first[1] + 1) * (size_t)(part->last[2] - part->first[2] + 1);
    if (cells->sparse && pencils > cells->pencils) {
        append_all_pencils(quest, part, own ? (size_t)cells_find_pencil(cells, own_y, own_z) : 0);
        return;
    }
    for (int z = own ? own_z : part->first[2]; z <= part->last[2]; z++) {
        int y0 = own && z == own_z ? own_y : part->first[1];
        if (empty_rows(cells, grid, y0, part->last[1], z)) {
            continue;
        }
        for (int y = y0; y <= part->last[1]; y++) {
            append_pencil(quest, part, y, z);
        }
    }
}

/* Candidates within the reach of the span, by windows. False if rows must go one by one. */
LANES_INLINE bool gather_windows(struct quest *quest) {
    const struct frame *frame = &quest->levels->frame;
    const struct search *search = quest->search;
    const struct span *span = &quest->span;
    const struct grid *grid = &search->level->grid;
    struct part part = {.reach = span->r_max + search->reach};
    struct window window[3];
    bool returns = false;
    for (int d = 0; d < 3; d++) {
        window[d] = window_of(frame, grid, d, span->low[d] - part.reach, span->high[d] + part.reach);
        returns = returns || window_returns(&window[d], span->own_low[d], span->own_high[d]);
    }
    if (search->half && returns && span->to - span->from > 1) {
        return false;
    }
    for (int pz = 0; pz < window[2].parts; pz++) {
        for (int py = 0; py < window[1].parts; py++) {
            for (int px = 0; px < window[0].parts; px++) {
                const int p[3] = {px, py, pz};
                for (int d = 0; d < 3; d++) {
                    part.first[d] = window[d].first[p[d]];
                    part.last[d] = window[d].last[p[d]];
                    part.shift[d] = window[d].shift[p[d]];
                    part.low[d] = span->low[d] - part.shift[d];
                    part.high[d] = span->high[d] - part.shift[d];
                }
                part.bits = image_bits(window[0].image[px], window[1].image[py], window[2].image[pz]);
                part.round = part.last[1] - part.first[1] + part.last[2] - part.first[2] > 5;
                append_part(quest, &part, search->half && part.bits == 0);
            }
        }
    }
    return true;
}

/* Wraps cell c of direction d into the box; false if it lies in no box that is searched. */
LANES_INLINE bool wrap_cell(const struct frame *frame, const struct grid *grid, int d, int *c, int *image) {
    int n = grid->n[d];
    *image = *c < 0 ? -1 : *c >= n ? 1 : 0;
    *c -= *image * n;
    return *image == 0 || (frame->periodic[d] && *c >= 0 && *c < n);
}

/* The cells c - dx ... c + dx of a pencil, cut at the ends of the box. */
LANES_INLINE void append_stencil_run(struct quest *quest, const struct stencil_run *run, int cx,
                                     const int yz[2], const int image_yz[2]) {
    const struct frame *frame = &quest->levels->frame;
    const struct grid *grid = &quest->search->level->grid;
    int n = grid->n[0];
    for (int s = 0; s < 3; s++) {
        int image = s == 0 ? 0 : 2 * s - 3;
        int x0 = cx - run->dx - image * n, x1 = cx + run->dx - image * n;
        x0 = x0 > 0 ? x0 : 0;
        x1 = x1 < n - 1 ? x1 : n - 1;
        if (x0 > x1 || (image != 0 && !frame->periodic[0])) {
            continue;
        }
        const float shift[3] = {(float)image * frame->edge[0], (float)image_yz[0] * frame->edge[1],
                                (float)image_yz[1] * frame->edge[2]};
        append(quest, cells_run(quest->search->cells, grid, x0, x1, yz[0], yz[1]), shift,
               image_bits(image, image_yz[0], image_yz[1]));
    }
}

/* Candidates by the stencil of the class; the block lies in one cell. False if rows must go one by one. */
LANES_INLINE bool gather_stencil(struct quest *quest) {
    const struct frame *frame = &quest->levels->frame;
    const struct search *search = quest->search;
    const struct stencil *stencil = search->stencil;
    const struct grid *grid = &search->level->grid;
    const int *own = quest->span.own_low;
    for (int d = 0; d < 3; d++) {
        if (search->half && quest->span.to - quest->span.from > 1 && frame->periodic[d] &&
            stencil->extent[d] >= grid->n[d]) {
            return false;
        }
    }
    if (search->half) {
        const int yz[2] = {own[1], own[2]}, here[2] = {0, 0};
        append_stencil_run(quest, &stencil->run[stencil->middle], own[0], yz, here);
    }
    for (size_t k = 0; k < stencil->count; k++) {
        int yz[2] = {own[1] + stencil->run[k].dy, own[2] + stencil->run[k].dz}, image[2];
        bool inside =
            wrap_cell(frame, grid, 1, &yz[0], &image[0]) && wrap_cell(frame, grid, 2, &yz[1], &image[1]);
        bool earlier = search->half && image[0] == 0 && image[1] == 0 && k <= stencil->middle;
        if (inside && !earlier) {
            append_stencil_run(quest, &stencil->run[k], own[0], yz, image);
        }
    }
    return true;
}

LANES_INLINE bool gather(struct quest *quest) {
    quest->buffer.count = 0;
    quest->buffer.continued = false;
    return quest->search->stencil != NULL ? gather_stencil(quest) : gather_windows(quest);
}

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
