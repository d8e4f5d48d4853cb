/* SPDX-License-Identifier: BSD-3-Clause */
/* The inner part of the search (search_rows.h tells the whole): the candidates of a span of rows, and the
 * test of every row against them. Included after a lanes_*.h. */
#ifndef SCREE_INDEX_SEARCH_SEARCH_PAIRS_H
#define SCREE_INDEX_SEARCH_SEARCH_PAIRS_H

#include "index/exact_test.h"
#include "index/search/search.h"
#include "index/search_sizes.h"

#include <stdalign.h>

/* n more events that a search has a price for (index/prices.h). A file that includes this one may count them. */
#ifndef SEARCH_EVENT
#define SEARCH_EVENT(term, n) ((void)0)
#endif

enum { ROWS = SEARCH_ROWS, OWN_ROWS = SEARCH_OWN_ROWS, SLOTS_APART = 128, CANDIDATES = 512 };

struct block {
    int rows;
    int size_class;
    size_t pencil; /* that holds the slots, in a dense table without stencils */
    uint32_t particle[ROWS], slot[ROWS];
    float x[3][ROWS], r[ROWS];
};

/* The number of rows of a block, rounded up to whole vectors. */
LANES_INLINE int rows_whole(int rows) {
    return (rows + LANES - 1) / LANES * LANES;
}

/* The rows from ... to - 1 of the block, which are searched together. */
struct span {
    int from, to;
    uint32_t first_slot;
    float low[3], high[3], r_max;
    int own_low[3], own_high[3]; /* cells of the rows in their own grid */
};

struct candidates {
    size_t count;
    bool continued; /* part of the search's candidates went through the buffer before */
    alignas(64) float x[CANDIDATES + 2 * LANES], y[CANDIDATES + 2 * LANES], z[CANDIDATES + 2 * LANES];
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

/* The candidate of row i as found among the slots, with the code of its image (of the particles, not of the places of
 * their slots, which may be images of particles that have crossed a face since they were sorted). Codes are added like
 * the vectors, modulo 27. */
LANES_INLINE uint32_t untwisted(const struct levels_stay *stay, uint32_t i, uint32_t tagged) {
    const uint32_t j = tagged & (((uint32_t)1 << INDEX_IMAGE_SHIFT) - 1);
    const unsigned code = (tagged >> INDEX_IMAGE_SHIFT) + stay->turn[j] + IMAGE_CODES - stay->turn[i];
    return j | code % IMAGE_CODES << INDEX_IMAGE_SHIFT;
}

/* Corrects the images of the pairs of row i from `first` on. */
static LANES_TARGET __attribute__((noinline)) void untwist(const struct quest *quest, struct index_sink *sink,
                                                           size_t first, uint32_t i) {
    for (size_t k = first; k < sink->count && k < sink->capacity; k++) {
        sink->j[k] = untwisted(&quest->levels->stay, i, sink->j[k]);
    }
}

/* The pairs among the `doubtful` ones (possible, not certain) of LANES candidates. `bits` is the code of
 * their image, or 0 if the candidate numbers hold the code. */
LANES_INLINE unsigned decide(const struct quest *quest, uint32_t i, const uint32_t *candidate, uint32_t bits,
                             unsigned doubtful) {
    unsigned kept = 0;
    for (unsigned rest = doubtful; rest != 0; rest &= rest - 1) {
        unsigned k = (unsigned)__builtin_ctz(rest);
        uint32_t tagged = candidate[k] | bits;
        if (quest->levels->stay.turned) {
            tagged = untwisted(&quest->levels->stay, i, tagged);
        }
        uint32_t j = tagged & (((uint32_t)1 << INDEX_IMAGE_SHIFT) - 1);
        int image[3];
        image_vector(tagged >> INDEX_IMAGE_SHIFT, image);
        bool keep =
            exact_near(quest->view, i, j, image) && (!quest->search->home || exact_home(quest->view, i, j));
        kept |= (unsigned)keep << k;
    }
    return kept;
}

/* Emits the possible partners among the candidates from `at` on. True if some partners are
 * doubtful: with `exact` the exact test decided these partners, else all of these were emitted. */
LANES_INLINE bool emit_row(struct quest *quest, const struct lanes_row *row, uint32_t i, size_t at,
                           bool exact) {
    const struct candidates *buffer = &quest->buffer;
    struct index_sink sink = quest->sink;
    size_t first = sink.count;
    lanes_mask doubt, doubtful = lanes_none();
    unsigned open = ~0u << at % LANES; /* whole vectors are tested: candidates before `at` do not count */
    for (at -= at % LANES; at < buffer->count; at += LANES) {
        SEARCH_EVENT(COST_TEST, 1);
        unsigned chosen =
            lanes_test(row, buffer->x + at, buffer->y + at, buffer->z + at, buffer->r + at, &doubt) & open;
        doubtful = lanes_either(doubtful, doubt);
        if (exact && (lanes_bits(doubt) & open) != 0) {
            chosen ^=
                (lanes_bits(doubt) & open) ^ decide(quest, i, buffer->j + at, 0, lanes_bits(doubt) & open);
        }
        open = ~0u;
        if (sink.count < sink.capacity) {
            sink.count += lanes_put(sink.j + sink.count, buffer->j + at, chosen);
        } else {
            sink.count += (unsigned)__builtin_popcount(chosen);
        }
    }
    for (size_t k = first; k < sink.count && k < sink.capacity; k += LANES) {
        lanes_fill(sink.i + k, i);
    }
    if (quest->levels->stay.turned) {
        untwist(quest, &sink, first, i);
    }
    quest->sink.count = sink.count;
    return lanes_bits(doubtful) != 0;
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
    struct lanes_row row = lanes_row(block->x[0][k], block->x[1][k], block->x[2][k],
                                     block->r[k] + search->margin, search->certain);
    size_t at = search->half && !quest->buffer.continued ? block->slot[k] - quest->span.first_slot : 0;
    size_t count = quest->sink.count;
    if (emit_row(quest, &row, i, at, false)) {
        quest->sink.count = count;
        emit_row_exactly(quest, &row, i, at);
    }
}

/* How far x lies outside of [low, high]. */
LANES_INLINE float beyond(float low, float high, float x) {
    float under = low - x, over = x - high, out = under > over ? under : over;
    return out > 0 ? out : 0;
}

/* True if some candidate may be within reach of some row of the span, by the box around the rows. */
LANES_INLINE bool span_met(const struct quest *quest) {
    const struct candidates *buffer = &quest->buffer;
    const struct span *span = &quest->span;
    const float margin = span->r_max + quest->search->margin;
    int met = 0;
    SEARCH_EVENT(COST_TEST, (buffer->count + LANES - 1) / LANES);
#pragma omp simd reduction(| : met)
    for (size_t k = 0; k < buffer->count; k++) {
        float dx = beyond(span->low[0], span->high[0], buffer->x[k]);
        float dy = beyond(span->low[1], span->high[1], buffer->y[k]);
        float dz = beyond(span->low[2], span->high[2], buffer->z[k]);
        float reach = buffer->r[k] + margin;
        met |= dx * dx + dy * dy + dz * dz <= reach * reach * (1 + 0x1p-18f);
    }
    return met != 0;
}

/* Tests all rows against the buffer and empties it. */
LANES_INLINE void flush(struct quest *quest) {
    struct candidates *buffer = &quest->buffer;
    if (buffer->count > 0 && (quest->search->half || quest->search->single || span_met(quest))) {
        for (size_t k = buffer->count; k < buffer->count + LANES; k++) {
            buffer->x[k] = buffer->y[k] = buffer->z[k] = 1e30f; /* too far from every row */
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

#endif
