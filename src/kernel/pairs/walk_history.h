/* SPDX-License-Identifier: BSD-3-Clause */
/* The history of a batch (walk.h): old records are found, and new ones are appended. Included by walk_block.c alone,
 * which is compiled for several instruction sets. */
#ifndef SCREE_PAIRS_WALK_HISTORY_H
#define SCREE_PAIRS_WALK_HISTORY_H

#include "kernel/pairs/walk_four.h"
#include "kernel/pairs/walk_kernel.h"
#include <string.h>

/* The history of the batch where each of its pairs has one: records lie side by side. Reads up to a record of
 * padding at a time. */
static inline void walk_recall_run(struct walk_batch *restrict b, const double *restrict value,
                                   int components) {
    if (components == WALK_QUAD) {
        for (int k = 0; k < b->count; k += WALK_QUAD) {
            const walk_four *from = (const walk_four *)value + k;
            walk_four out[WALK_QUAD];
            walk_turn(out, from[0], from[1], from[2], from[3]);
            for (int row = 0; row < WALK_QUAD; row++)
                *(walk_four *)&b->history[row][k] = out[row];
        }
        return;
    }
    if (components % 3 != 0) {
        for (int k = 0; k < b->count; k++)
            for (int c = 0; c < components; c++)
                b->history[c][k] = value[k * components + c];
        return;
    }
    for (int k = 0; k < b->count; k += WALK_QUAD)
        for (int c = 0; c < components; c += 3) {
            const double *from = value + k * components + c;
            walk_four out[WALK_QUAD];
            walk_turn(out, *(const walk_four *)from, *(const walk_four *)(from + components),
                      *(const walk_four *)(from + 2 * components),
                      *(const walk_four *)(from + 3 * components));
            for (int row = 0; row < 3; row++)
                *(walk_four *)&b->history[c + row][k] = out[row];
        }
}

/* Finds the old records of the batch's pairs: both run in the order of the pairs. Most often no contact has
 * come or gone. */
static inline void walk_recall(const struct history_part old, struct walk_thread *restrict thread,
                               int components) {
    struct walk_batch *restrict b = thread->batch;
    size_t cursor = thread->cursor, count = (size_t)b->count;
    while (cursor < old.count && old.pair[cursor] < b->pair[0])
        cursor++;
    if (cursor + count <= old.count && memcmp(old.pair + cursor, b->pair, count * sizeof *b->pair) == 0) {
        walk_recall_run(b, old.value + cursor * (size_t)components, components);
        thread->cursor = cursor + count;
        return;
    }
    for (size_t k = 0; k < count; k++) {
        uint32_t pair = b->pair[k];
        while (cursor < old.count && old.pair[cursor] < pair)
            cursor++;
        bool known = cursor < old.count && old.pair[cursor] == pair;
        for (int c = 0; c < components; c++)
            b->history[c][k] = known ? old.value[cursor * (size_t)components + (size_t)c] : 0.0;
    }
    thread->cursor = cursor;
}

/* Appends the new records of the batch to the other buffer. Each store of three components spills into the
 * next, which is written after it: at the end, into the padding. */
static inline void walk_remember(struct history_part *new, const struct walk_batch *restrict b,
                                 int components) {
    double *restrict value = new->value + new->count *(size_t)components;
    memcpy(new->pair + new->count, b->pair, (size_t)b->count * sizeof *b->pair);
    for (int k = 0; components == WALK_QUAD && k < b->count; k += WALK_QUAD) {
        const double(*from)[WALK_BATCH] = b->history;
        walk_turn((walk_four *)value + k, *(const walk_four *)&from[0][k], *(const walk_four *)&from[1][k],
                  *(const walk_four *)&from[2][k], *(const walk_four *)&from[3][k]);
    }
    for (int k = 0; components != WALK_QUAD && components % 3 != 0 && k < b->count; k++)
        for (int c = 0; c < components; c++)
            value[k * components + c] = b->history[c][k];
    for (int k = 0; components % 3 == 0 && k < b->count; k += WALK_QUAD) {
        walk_four half[HISTORY_COMPONENTS_MAX / 3][WALK_QUAD];
        for (int c = 0; c < components; c += 3) {
            walk_four z = *(const walk_four *)&b->history[c + 2][k];
            walk_turn(half[c / 3], *(const walk_four *)&b->history[c][k],
                      *(const walk_four *)&b->history[c + 1][k], z, z);
        }
        for (int m = 0; m < WALK_QUAD; m++)
            for (int c = 0; c < components; c += 3)
                *(walk_four *)(value + (k + m) * components + c) = half[c / 3][m];
    }
    new->count += (size_t)b->count;
}

#endif
