/* SPDX-License-Identifier: BSD-3-Clause */
/* The search of a dense table by rows of its own, or by larger ones (search_rows.h tells the whole): each row
 * looks up its own window in every pencil and tests it where it lies. Such windows are about as long as a
 * vector, and to copy candidates together for a span of rows costs more than it saves. Included after a
 * lanes_*.h.
 *
 * In the rows' own table a pencil before the row's own holds earlier slots alone and is not looked at. A
 * window that meets images of the box moves the row, not the candidates. */
#ifndef SCREE_INDEX_SEARCH_SEARCH_DIRECT_H
#define SCREE_INDEX_SEARCH_SEARCH_DIRECT_H

#include "index/search/search_gather.h"

#include <string.h>

/* The cells around each row of a block. */
struct windows {
    bool half;        /* rows search their own table: from their own pencil on, behind their own slot */
    int own_y, own_z; /* the block's pencil; 0 unless half */
    int first[3][ROWS], last[3][ROWS];
    int images[ROWS]; /* bit d: images of the box in direction d may be met */
};

/* The windows of a vector of rows. */
LANES_INLINE void windows_of(const struct quest *quest, struct windows *restrict windows, int start) {
    const struct frame *frame = &quest->levels->frame;
    const struct grid grid = quest->search->level->grid;
    const float reach = quest->search->reach;
    const float *r = quest->block.r + start;
    int images[LANES] = {0};
    for (int d = 0; d < 3; d++) {
        const float low = frame->periodic[d] ? frame->all_low[d] + frame->tolerance * 4 : -INFINITY;
        const float high = frame->periodic[d] ? frame->all_high[d] - frame->tolerance * 4 : INFINITY;
        const float *x = quest->block.x[d] + start;
        int *restrict first = windows->first[d] + start, *restrict last = windows->last[d] + start;
#pragma omp simd
        for (int k = 0; k < LANES; k++) {
            float from = x[k] - (r[k] + reach), to = x[k] + (r[k] + reach);
            first[k] = grid_cell(&grid, d, from);
            last[k] = grid_cell(&grid, d, to);
            images[k] |= ((from <= low) | (to >= high)) << d;
        }
    }
    memcpy(windows->images + start, images, sizeof images);
}

/* The windows of all rows of the block. */
LANES_INLINE void windows_make(const struct quest *quest, struct windows *restrict windows) {
    const struct block *block = &quest->block;
    const int ny = quest->search->level->grid.n[1], rows = block->rows;
    windows->half = quest->search->half;
    windows->own_y = windows->half ? (int)(block->pencil % (size_t)ny) : 0;
    windows->own_z = windows->half ? (int)(block->pencil / (size_t)ny) : 0;
    for (int from = 0; from < rows; from += LANES) {
        windows_of(quest, windows, from);
    }
}

/* The coordinates, numbers and cells of a table, as direct_row looks at them. */
struct table {
    const float *x, *y, *z, *r;
    const uint32_t *particle, *begin;
    size_t nx, ny;
};

/* A row at work. */
struct direct {
    const struct quest *quest;
    uint32_t i;
    struct lanes_row row;
    struct table table;
    struct index_sink sink;
    lanes_mask doubtful;
    uint32_t bits; /* code of the image that is searched, in the upper bits */
};

/* Tests the row against the first `count` of LANES slots and emits its possible partners; with `exact` only
 * the certain ones and those that prove to be partners. */
LANES_INLINE void direct_slots(struct direct *direct, uint32_t from, uint32_t count, bool exact) {
    const struct table *table = &direct->table;
    lanes_mask doubt;
    SEARCH_EVENT(COST_VECTOR, 1);
    unsigned open = (1u << count) - 1;
    unsigned chosen =
        lanes_test(&direct->row, table->x + from, table->y + from, table->z + from, table->r + from, &doubt);
    chosen &= open;
    direct->doubtful = lanes_either(direct->doubtful, doubt);
    if (exact) {
        unsigned unsure = lanes_bits(doubt) & open;
        chosen ^= unsure ^ decide(direct->quest, direct->i, table->particle + from, direct->bits, unsure);
    }
    if (direct->sink.count < direct->sink.capacity) {
        uint32_t *out = direct->sink.j + direct->sink.count;
        direct->sink.count += lanes_put(out, table->particle + from, chosen);
        if (direct->bits != 0) {
            lanes_copy_tagged(out, out, direct->bits);
        }
    } else {
        direct->sink.count += (unsigned)__builtin_popcount(chosen);
    }
}

/* The partners of row k, whose window meets no image. */
LANES_INLINE void direct_pencils(struct direct *direct, const struct windows *windows, int k, bool exact) {
    const struct table *table = &direct->table;
    const size_t x0 = (size_t)windows->first[0][k], x1 = (size_t)windows->last[0][k] + 1;
    const int y0 = windows->first[1][k], y1 = windows->last[1][k], z1 = windows->last[2][k];
    uint32_t own = windows->half ? direct->quest->block.slot[k] + 1 : 0;
    int z = windows->half ? windows->own_z : windows->first[2][k], y = windows->half ? windows->own_y : y0;
    for (; z <= z1; z++, y = y0) {
        const uint32_t *begin = table->begin + ((size_t)z * table->ny + (size_t)y) * table->nx;
        for (; y <= y1; y++, begin += table->nx) {
            uint32_t from = own ? own : begin[x0], to = begin[x1];
            own = 0;
            SEARCH_EVENT(COST_WINDOW, 1);
            SEARCH_EVENT(COST_LONG, to - from > SEARCH_LONG);
            for (; to - from > LANES; from += LANES) {
                direct_slots(direct, from, LANES, exact);
            }
            direct_slots(direct, from, to - from, exact); /* also if there are none: cheaper than a test */
        }
    }
}

/* The pencils of one image of the box, which is number p[d] of the row's windows in each direction, from slot
 * `start` on. */
LANES_INLINE void direct_image(struct direct *direct, const struct windows *windows,
                               const struct window window[3], const int p[3], uint32_t start, bool exact) {
    const struct search *search = direct->quest->search;
    const int x0 = window[0].first[p[0]], x1 = window[0].last[p[0]];
    const int y0 = window[1].first[p[1]], y1 = window[1].last[p[1]];
    const int z0 = window[2].first[p[2]], z1 = window[2].last[p[2]];
    for (int z = z0 > windows->own_z ? z0 : windows->own_z; z <= z1; z++) {
        for (int y = z == windows->own_z && y0 < windows->own_y ? windows->own_y : y0; y <= y1; y++) {
            struct cells_slice slice = cells_run(search->cells, &search->level->grid, x0, x1, y, z);
            uint32_t from = slice.begin > start ? slice.begin : start;
            SEARCH_EVENT(COST_WINDOW, 1);
            SEARCH_EVENT(COST_LONG, slice.end > from + SEARCH_LONG);
            for (; from < slice.end; from += LANES) {
                direct_slots(direct, from, slice.end - from < LANES ? slice.end - from : LANES, exact);
            }
        }
    }
}

/* The partners of row k in all images that its window meets. */
LANES_INLINE void direct_images(struct direct *direct, const struct windows *windows, int k, bool exact) {
    const struct quest *quest = direct->quest;
    const struct search *search = quest->search;
    const struct block *block = &quest->block;
    const float reach = block->r[k] + search->reach, r = block->r[k] + search->margin;
    const uint32_t start = windows->half ? block->slot[k] + 1 : 0;
    struct window window[3];
    for (int d = 0; d < 3; d++) {
        const float at = block->x[d][k];
        if (windows->images[k] & 1 << d) {
            window[d] = window_of(&quest->levels->frame, &search->level->grid, d, at - reach, at + reach);
        } else {
            window[d] =
                (struct window){.parts = 1, .first = {windows->first[d][k]}, .last = {windows->last[d][k]}};
        }
    }
    int p[3];
    for (p[2] = 0; p[2] < window[2].parts; p[2]++) {
        if (window[2].last[p[2]] < windows->own_z) {
            continue; /* earlier slots alone */
        }
        for (p[1] = 0; p[1] < window[1].parts; p[1]++) {
            for (p[0] = 0; p[0] < window[0].parts; p[0]++) {
                direct->row =
                    lanes_row(block->x[0][k] - window[0].shift[p[0]], block->x[1][k] - window[1].shift[p[1]],
                              block->x[2][k] - window[2].shift[p[2]], r, search->certain);
                direct->bits =
                    image_bits(window[0].image[p[0]], window[1].image[p[1]], window[2].image[p[2]]);
                direct_image(direct, windows, window, p, start, exact);
            }
        }
    }
}

static LANES_TARGET size_t direct_row_exactly(const struct quest *quest, const struct windows *windows, int k,
                                              size_t count);

/* The present search at work on no row yet. */
LANES_INLINE struct direct direct_start(const struct quest *quest) {
    const struct cells *cells = quest->search->cells;
    const int *n = quest->search->level->grid.n;
    return (struct direct){.quest = quest,
                           .table = {.x = cells->x,
                                     .y = cells->y,
                                     .z = cells->z,
                                     .r = cells->r,
                                     .particle = cells->particle,
                                     .begin = cells->begin,
                                     .nx = (size_t)n[0],
                                     .ny = (size_t)n[1]},
                           .sink = quest->sink};
}

/* All partners of row k; without `exact` the row begins again exactly where some are doubtful. */
LANES_INLINE void direct_row(struct direct *direct, const struct windows *windows, int k, bool images,
                             bool exact) {
    const struct quest *quest = direct->quest;
    const struct block *block = &quest->block;
    const struct search *search = quest->search;
    const size_t first = direct->sink.count;
    direct->i = block->particle[k];
    direct->row = lanes_row(block->x[0][k], block->x[1][k], block->x[2][k], block->r[k] + search->margin,
                            search->certain);
    direct->doubtful = lanes_none();
    if (images) {
        direct_images(direct, windows, k, exact);
    } else {
        direct_pencils(direct, windows, k, exact);
    }
    if (!exact && lanes_bits(direct->doubtful) != 0) {
        direct->sink.count = direct_row_exactly(quest, windows, k, first);
        return;
    }
    for (size_t at = first; at < direct->sink.count && at < direct->sink.capacity; at += LANES) {
        lanes_fill(direct->sink.i + at, direct->i);
    }
    if (images && quest->levels->stay.turned) { /* particles that have crossed a face lie near it */
        untwist(quest, &direct->sink, first, direct->i);
    }
}

/* The rare cases, apart from the fast one: the partners of row k behind the first `count` pairs of the sink; the
 * number of pairs with them. */
static LANES_TARGET __attribute__((noinline)) size_t
direct_row_exactly(const struct quest *quest, const struct windows *windows, int k, size_t count) {
    struct direct direct = direct_start(quest);
    direct.sink.count = count;
    direct_row(&direct, windows, k, windows->images[k] != 0, true);
    return direct.sink.count;
}

static LANES_TARGET __attribute__((noinline)) size_t
direct_row_images(const struct quest *quest, const struct windows *windows, int k, size_t count) {
    struct direct direct = direct_start(quest);
    direct.sink.count = count;
    direct_row(&direct, windows, k, true, false);
    return direct.sink.count;
}

/* Searches the rows of the block. A separate function, so that its data stay in registers. */
static LANES_TARGET __attribute__((noinline)) void direct_rows(struct quest *quest,
                                                               const struct windows *windows) {
    const int rows = quest->block.rows;
    struct direct direct = direct_start(quest);
    for (int k = 0; k < rows; k++) {
        if (windows->images[k] == 0) {
            direct_row(&direct, windows, k, false, false);
        } else {
            direct.sink.count = direct_row_images(quest, windows, k, direct.sink.count);
        }
    }
    quest->sink.count = direct.sink.count;
}

#endif
