/* SPDX-License-Identifier: BSD-3-Clause */
/* Eight lanes in plain C, for any CPU. This file shows the names that every lanes_*.h must define. */
#ifndef SCREE_INDEX_SEARCH_LANES_PLAIN_H
#define SCREE_INDEX_SEARCH_LANES_PLAIN_H

#include "index/index.h"

#ifdef __clang__
#pragma clang diagnostic ignored "-Wpass-failed" /* checked builds do not vectorise the loops */
#endif

#define LANES_TARGET
#define LANES_INLINE static inline __attribute__((always_inline))

enum { LANES = 8 };

/* One row against which candidates are tested: its coordinates, its radius with margin, and which share of
 * the squared cut-off is certain. */
struct lanes_row {
    float x, y, z, r, certain;
};

LANES_INLINE struct lanes_row lanes_row(float x, float y, float z, float r, float certain) {
    return (struct lanes_row){x, y, z, r, certain};
}

/* A yes or no for each of LANES candidates; lanes_bits gives the mask as a number. */
typedef unsigned lanes_mask;

LANES_INLINE lanes_mask lanes_none(void) {
    return 0;
}

LANES_INLINE lanes_mask lanes_either(lanes_mask a, lanes_mask b) {
    return a | b;
}

LANES_INLINE unsigned lanes_bits(lanes_mask mask) {
    return mask;
}

/* Tests LANES candidates. Bit k of the result: candidate k may be a partner. Bit k of *doubtful: candidate k
 * may be no partner. */
LANES_INLINE unsigned lanes_test(const struct lanes_row *row, const float *x, const float *y, const float *z,
                                 const float *r, lanes_mask *doubtful) {
    float square[LANES], cutoff[LANES];
#pragma omp simd
    for (int k = 0; k < LANES; k++) {
        float dx = x[k] - row->x, dy = y[k] - row->y, dz = z[k] - row->z, c = r[k] + row->r;
        square[k] = dx * dx + dy * dy + dz * dz;
        cutoff[k] = c * c;
    }
    unsigned possible = 0, sure = 0;
    for (int k = 0; k < LANES; k++) {
        possible |= (unsigned)(square[k] <= cutoff[k]) << k;
        sure |= (unsigned)(square[k] <= cutoff[k] * row->certain) << k;
    }
    *doubtful = possible & ~sure;
    return possible;
}

/* Writes the chosen of LANES candidates; may write LANES entries. Returns the number of chosen candidates. */
LANES_INLINE unsigned lanes_put(uint32_t *out, const uint32_t *j, unsigned chosen) {
    unsigned count = 0;
    for (; chosen != 0; chosen &= chosen - 1) {
        out[count++] = j[__builtin_ctz(chosen)];
    }
    return count;
}

/* Writes i to LANES entries. */
LANES_INLINE void lanes_fill(uint32_t *out, uint32_t i) {
    for (int k = 0; k < LANES; k++) {
        out[k] = i;
    }
}

/* to[k] = from[k] + shift, and to[k] = from[k] | bits, for LANES entries. */
LANES_INLINE void lanes_copy(float *to, const float *from, float shift) {
    for (int k = 0; k < LANES; k++) {
        to[k] = from[k] + shift;
    }
}

LANES_INLINE void lanes_copy_tagged(uint32_t *to, const uint32_t *from, uint32_t bits) {
    for (int k = 0; k < LANES; k++) {
        to[k] = from[k] | bits;
    }
}

#endif
