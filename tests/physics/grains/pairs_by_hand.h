/* SPDX-License-Identifier: BSD-3-Clause */
/* A pair list made by brute force, with all the segments that a real one has, for tests of what uses one. */
#ifndef SCREE_TESTS_PAIRS_BY_HAND_H
#define SCREE_TESTS_PAIRS_BY_HAND_H

#include "base/memory.h"
#include "kernel/pairs/pairlist.h"
#include <math.h>
#include <string.h>

enum { HAND_PAIRS = 1 << 18, HAND_THREADS = 4, HAND_BLOCK_ROWS = 37 };

/* What a hand-made list is made of. */
struct hand_options {
    int threads;
    double margin; /* pairs up to r_i + r_j + margin */
    double edge;   /* periodic cube of this edge; 0: open */
    double busy;   /* particles of at least this radius get slots; 0: none */
};

static inline int hand_thread_of(size_t k, size_t n, int threads) {
    return (int)(k * (size_t)threads / n);
}

static inline bool hand_is_busy(const struct particles *p, size_t k, const struct hand_options *o) {
    return o->busy > 0.0 && o->threads > 1 && p->state[k].radius >= o->busy;
}

static inline bool hand_near(const struct particles *p, const struct pairlist *list, size_t i, size_t j,
                             unsigned code, double margin) {
    double square = 0.0, reach = p->state[i].radius + p->state[j].radius + margin;
    for (int c = 0; c < 3; c++) {
        double d = p->state[j].x[c] - p->state[i].x[c] + list->shift[code][c];
        square += d * d;
    }
    return square < reach * reach;
}

static inline void hand_append(struct pairlist *list, size_t i, size_t j, unsigned code) {
    list->i[list->pair_count] = (uint32_t)i;
    list->j[list->pair_count++] = (uint32_t)(j | code << PARTICLE_INDEX_BITS);
}

/* Appends the pairs of rows [first, last) that belong into a segment: 0 both, 1 one-sided, 2 slot; 3: the
 * mirrored pairs of a thread's particles. Each pair is seen from the row with the lower number, or from the
 * particle that is not busy. */
static inline void hand_segment(struct pairlist *list, const struct particles *p,
                                const struct hand_options *o, size_t first, size_t last, int segment) {
    size_t n = p->owned;
    for (size_t i = first; i < last; i++)
        for (size_t j = 0; j < n; j++)
            for (unsigned code = 0; code < (o->edge > 0.0 ? IMAGE_CODES : 1u); code++) {
                bool busy_i = hand_is_busy(p, i, o), busy_j = hand_is_busy(p, j, o);
                bool row_is_i = busy_i == busy_j ? i < j || (i == j && code > image_opposite(code)) : busy_j;
                bool crosses = hand_thread_of(i, n, o->threads) != hand_thread_of(j, n, o->threads);
                int where = !row_is_i ? (crosses && !busy_i ? 3 : -1) : busy_j ? 2 : crosses ? 1 : 0;
                if (where == segment && (i != j || code) && hand_near(p, list, i, j, code, o->margin))
                    hand_append(list, i, j, code);
            }
}

static inline void hand_block(struct pairlist *list, const struct particles *p, const struct hand_options *o,
                              enum pair_block_kind kind, size_t first, size_t last) {
    struct pair_block *block = &list->blocks[list->block_count++];
    bool rows = kind == PAIR_BLOCK_ROWS;
    *block = (struct pair_block){.first_row = rows ? (uint32_t)first : 0,
                                 .last_row = rows ? (uint32_t)last : 0,
                                 .first_pair = list->pair_count,
                                 .kind = kind};
    if (rows)
        hand_segment(list, p, o, first, last, 0);
    block->one_sided = list->pair_count;
    if (rows)
        hand_segment(list, p, o, first, last, 1);
    if (kind == PAIR_BLOCK_MIRROR)
        hand_segment(list, p, o, first, last, 3);
    block->slotted = list->pair_count;
    if (rows)
        hand_segment(list, p, o, first, last, 2);
    block->end_pair = list->pair_count;
}

/* Makes the list; hand_free releases it. */
static inline void hand_make(struct pairlist *list, const struct particles *p, const struct hand_options *o) {
    memset(list, 0, sizeof *list);
    size_t n = p->owned;
    list->i = memory_allocate(HAND_PAIRS, sizeof *list->i, "pairs");
    list->j = memory_allocate(HAND_PAIRS, sizeof *list->j, "pairs");
    list->blocks = memory_allocate(n / HAND_BLOCK_ROWS + 4 * HAND_THREADS, sizeof *list->blocks, "blocks");
    list->thread_block = memory_allocate(HAND_THREADS + 1, sizeof *list->thread_block, "blocks");
    list->busy = memory_allocate(n, sizeof *list->busy, "busy");
    list->slot_of = memory_allocate(n, sizeof *list->slot_of, "slots");
    list->threads = o->threads;
    struct box box = {.dimension = 3, .edge = {o->edge, o->edge, o->edge}, .periodic = {1, 1, 1}};
    box_image_shifts(&box, list->shift);
    for (size_t k = 0; k < n; k++)
        if (hand_is_busy(p, k, o)) {
            list->slot_of[k] = (int32_t)list->slot_count;
            list->busy[list->slot_count++] = (uint32_t)k;
        }
    size_t row = 0;
    for (int t = 0; t < o->threads; t++) {
        size_t begin = row, end = row;
        list->thread_block[t] = list->block_count;
        while (end < n && hand_thread_of(end, n, o->threads) == t)
            end++;
        for (; row < end; row = row + HAND_BLOCK_ROWS < end ? row + HAND_BLOCK_ROWS : end)
            hand_block(list, p, o, PAIR_BLOCK_ROWS, row,
                       row + HAND_BLOCK_ROWS < end ? row + HAND_BLOCK_ROWS : end);
        hand_block(list, p, o, PAIR_BLOCK_MIRROR, begin, end);
        hand_block(list, p, o, PAIR_BLOCK_GHOST, begin, end);
    }
    list->thread_block[o->threads] = list->block_count;
}

static inline void hand_free(struct pairlist *list) {
    memory_free(list->i);
    memory_free(list->j);
    memory_free(list->blocks);
    memory_free(list->thread_block);
    memory_free(list->busy);
    memory_free(list->slot_of);
}

#endif
