/* Eight lanes in plain C, for any CPU. What a lanes_*.h must define, see here. */
#ifndef SCREE_INDEX_LANES_PLAIN_H
#define SCREE_INDEX_LANES_PLAIN_H

#include "index/index.h"

#ifdef __clang__
#pragma clang diagnostic ignored "-Wpass-failed" /* checked builds leave loops as they are: so be it */
#endif

#define LANES_TARGET
#define LANES_INLINE static inline __attribute__((always_inline))

enum { LANES = 8 };

/* One row against which candidates are tested: its coordinates, its radius with margin, and which share of
 * the squared cut-off is certain. */
struct lanes_row {
    float x, y, z, r, certain;
};

LANES_INLINE struct lanes_row lanes_row(const float x[3], float r, float certain) {
    return (struct lanes_row){x[0], x[1], x[2], r, certain};
}

/* Tests LANES candidates. Bit k of the result: candidate k may be a partner; of *doubtful: it may be none. */
LANES_INLINE unsigned lanes_test(const struct lanes_row *row, const float *x, const float *y, const float *z,
                                 const float *r, unsigned *doubtful) {
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

/* Writes the chosen of LANES candidates; may write LANES entries. Returns how many. */
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
