/* SPDX-License-Identifier: BSD-3-Clause */
/* Sixteen lanes of AVX-512. See lanes_plain.h. */
#ifndef SCREE_INDEX_SEARCH_LANES_AVX512_H
#define SCREE_INDEX_SEARCH_LANES_AVX512_H

#include "index/index.h"

#include <immintrin.h>

#define LANES_TARGET __attribute__((target("avx512f,avx512vl,avx2,fma,popcnt,bmi,bmi2")))
#define LANES_INLINE                                                                                         \
    static inline __attribute__((always_inline, target("avx512f,avx512vl,avx2,fma,popcnt,bmi,bmi2")))

enum { LANES = 16 };

struct lanes_row {
    __m512 x, y, z, r, certain;
};

LANES_INLINE struct lanes_row lanes_row(float x, float y, float z, float r, float certain) {
    return (struct lanes_row){_mm512_set1_ps(x), _mm512_set1_ps(y), _mm512_set1_ps(z), _mm512_set1_ps(r),
                              _mm512_set1_ps(certain)};
}

typedef __mmask16 lanes_mask;

LANES_INLINE lanes_mask lanes_none(void) {
    return 0;
}

LANES_INLINE lanes_mask lanes_either(lanes_mask a, lanes_mask b) {
    return a | b;
}

LANES_INLINE unsigned lanes_bits(lanes_mask mask) {
    return mask;
}

LANES_INLINE unsigned lanes_test(const struct lanes_row *row, const float *x, const float *y, const float *z,
                                 const float *r, lanes_mask *doubtful) {
    __m512 dx = _mm512_sub_ps(_mm512_loadu_ps(x), row->x);
    __m512 dy = _mm512_sub_ps(_mm512_loadu_ps(y), row->y);
    __m512 dz = _mm512_sub_ps(_mm512_loadu_ps(z), row->z);
    __m512 c = _mm512_add_ps(_mm512_loadu_ps(r), row->r);
    __m512 square = _mm512_fmadd_ps(dx, dx, _mm512_fmadd_ps(dy, dy, _mm512_mul_ps(dz, dz)));
    __m512 cutoff = _mm512_mul_ps(c, c);
    __mmask16 possible = _mm512_cmp_ps_mask(square, cutoff, _CMP_LE_OQ);
    *doubtful = _mm512_mask_cmp_ps_mask(possible, square, _mm512_mul_ps(cutoff, row->certain), _CMP_NLE_UQ);
    return possible;
}

/* Compressed in the register: compression straight into memory is slow on some CPUs. */
LANES_INLINE unsigned lanes_put(uint32_t *out, const uint32_t *j, unsigned chosen) {
    __m512i all = _mm512_loadu_si512((const void *)j);
    _mm512_storeu_si512((void *)out, _mm512_maskz_compress_epi32((__mmask16)chosen, all));
    return (unsigned)__builtin_popcount(chosen);
}

LANES_INLINE void lanes_fill(uint32_t *out, uint32_t i) {
    _mm512_storeu_si512((void *)out, _mm512_set1_epi32((int)i));
}

LANES_INLINE void lanes_copy(float *to, const float *from, float shift) {
    _mm512_storeu_ps(to, _mm512_add_ps(_mm512_loadu_ps(from), _mm512_set1_ps(shift)));
}

LANES_INLINE void lanes_copy_tagged(uint32_t *to, const uint32_t *from, uint32_t bits) {
    __m512i all = _mm512_loadu_si512((const void *)from);
    _mm512_storeu_si512((void *)to, _mm512_or_si512(all, _mm512_set1_epi32((int)bits)));
}

#endif
