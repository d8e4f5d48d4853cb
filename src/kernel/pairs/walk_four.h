/* SPDX-License-Identifier: BSD-3-Clause */
/* Four doubles that move together through the walk over pairs and through the laws; lowered to narrower registers
 * where the CPU has none so wide. Included by walk_block.c and by the laws' force_physics.h alone, which are
 * compiled for several instruction sets. */
#ifndef SCREE_PAIRS_WALK_FOUR_H
#define SCREE_PAIRS_WALK_FOUR_H

#include "kernel/pairs/walk.h"

#include <stddef.h>
#include <stdint.h>
#ifdef __AVX__
#include <immintrin.h>
#endif

typedef double walk_four __attribute__((vector_size(32), aligned(8), may_alias));
typedef int64_t walk_mask __attribute__((vector_size(32)));
typedef uint32_t walk_numbers __attribute__((vector_size(16), aligned(4), may_alias));

/* Rows to columns: out[k] is made of entry k of each. */
static inline void walk_turn(walk_four out[WALK_QUAD], walk_four x, walk_four y, walk_four z, walk_four w) {
    walk_four xy02 = __builtin_shufflevector(x, y, 0, 4, 2, 6),
              xy13 = __builtin_shufflevector(x, y, 1, 5, 3, 7),
              zw02 = __builtin_shufflevector(z, w, 0, 4, 2, 6),
              zw13 = __builtin_shufflevector(z, w, 1, 5, 3, 7);
    out[0] = __builtin_shufflevector(xy02, zw02, 0, 1, 4, 5);
    out[1] = __builtin_shufflevector(xy13, zw13, 0, 1, 4, 5);
    out[2] = __builtin_shufflevector(xy02, zw02, 2, 3, 6, 7);
    out[3] = __builtin_shufflevector(xy13, zw13, 2, 3, 6, 7);
}

/* The set lanes of a mask of comparison, as bits. */
static inline unsigned walk_bits(walk_mask mask) {
#ifdef __AVX__
    return (unsigned)_mm256_movemask_pd((__m256d)mask);
#else
    return (unsigned)(-mask[0] | -mask[1] << 1 | -mask[2] << 2 | -mask[3] << 3);
#endif
}

/* Lanes of the set bits of a number below 16, lowest first. */
static const uint32_t walk_place[16][WALK_QUAD] = {
    {0}, {0},    {1},    {0, 1},    {2},    {0, 2},    {1, 2},    {0, 1, 2},
    {3}, {0, 3}, {1, 3}, {0, 1, 3}, {2, 3}, {0, 2, 3}, {1, 2, 3}, {0, 1, 2, 3}};

/* Appends those of the pairs k ... k + 3 whose bit is set. */
static inline uint32_t *walk_append(uint32_t *out, size_t k, unsigned touching) {
    *(walk_numbers *)out = *(const walk_numbers *)walk_place[touching] + (uint32_t)k;
    return out + __builtin_popcount(touching);
}

#endif
