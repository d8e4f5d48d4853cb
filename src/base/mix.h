/* SPDX-License-Identifier: BSD-3-Clause */
/* The mixer of bits: checksums, hash tables, and numbers that look drawn but belong to an id. Checksums in files depend on it. */
#ifndef SCREE_BASE_MIX_H
#define SCREE_BASE_MIX_H

#include <stdint.h>

#define MIX_GOLDEN UINT64_C(0x9e3779b97f4a7c15) /* 2^64 over the golden ratio, odd */

/* The finaliser of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014, variant 13 of Stafford): every bit of the
 * input moves every bit of the output. */
static inline uint64_t mix_bits(uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    bits = (bits ^ (bits >> 27)) * UINT64_C(0x94d049bb133111eb);
    return bits ^ (bits >> 31);
}

/* The hash of what has the hash `hash`, followed by a word. */
static inline uint64_t mix_word(uint64_t hash, uint64_t word) {
    return mix_bits((hash ^ word) + MIX_GOLDEN);
}

/* The hash of a cell of grid number `grid`. */
static inline uint64_t mix_cell(uint64_t grid, const int64_t cell[3]) {
    return mix_word(mix_word(mix_word(grid, (uint64_t)cell[0]), (uint64_t)cell[1]), (uint64_t)cell[2]);
}

#endif
