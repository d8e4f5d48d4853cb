/* SPDX-License-Identifier: BSD-3-Clause */
/* Eight lanes of AVX2. See lanes_plain.h. */
#ifndef SCREE_INDEX_SEARCH_LANES_AVX2_H
#define SCREE_INDEX_SEARCH_LANES_AVX2_H

#include "index/index.h"

#include <immintrin.h>

#define LANES_TARGET __attribute__((target("avx2,fma,popcnt,bmi,bmi2")))
#define LANES_INLINE static inline __attribute__((always_inline, target("avx2,fma,popcnt,bmi,bmi2")))

enum { LANES = 8 };

struct lanes_row {
    __m256 x, y, z, r, certain;
};

LANES_INLINE struct lanes_row lanes_row(float x, float y, float z, float r, float certain) {
    return (struct lanes_row){_mm256_set1_ps(x), _mm256_set1_ps(y), _mm256_set1_ps(z), _mm256_set1_ps(r),
                              _mm256_set1_ps(certain)};
}

typedef __m256 lanes_mask;

LANES_INLINE lanes_mask lanes_none(void) {
    return _mm256_setzero_ps();
}

LANES_INLINE lanes_mask lanes_either(lanes_mask a, lanes_mask b) {
    return _mm256_or_ps(a, b);
}

LANES_INLINE unsigned lanes_bits(lanes_mask mask) {
    return (unsigned)_mm256_movemask_ps(mask);
}

LANES_INLINE unsigned lanes_test(const struct lanes_row *row, const float *x, const float *y, const float *z,
                                 const float *r, lanes_mask *doubtful) {
    __m256 dx = _mm256_sub_ps(row->x, _mm256_loadu_ps(x));
    __m256 dy = _mm256_sub_ps(row->y, _mm256_loadu_ps(y));
    __m256 dz = _mm256_sub_ps(row->z, _mm256_loadu_ps(z));
    __m256 c = _mm256_add_ps(row->r, _mm256_loadu_ps(r));
    __m256 square = _mm256_fmadd_ps(dx, dx, _mm256_fmadd_ps(dy, dy, _mm256_mul_ps(dz, dz)));
    __m256 cutoff = _mm256_mul_ps(c, c);
    __m256 sure = _mm256_cmp_ps(square, _mm256_mul_ps(cutoff, row->certain), _CMP_LE_OQ);
    __m256 possible = _mm256_cmp_ps(square, cutoff, _CMP_LE_OQ);
    *doubtful = _mm256_andnot_ps(sure, possible);
    return (unsigned)_mm256_movemask_ps(possible);
}

/* The numbers of the set bits of m, lowest first, a byte each. */
#define LANES_PLACE(m, k)                                                                                    \
    ((m) >> (k)&1 ? (uint64_t)(k) << 8 * __builtin_popcount((m) & ((1u << (k)) - 1)) : 0)
#define LANES_PLACES(m)                                                                                      \
    LANES_PLACE(m, 0) | LANES_PLACE(m, 1) | LANES_PLACE(m, 2) | LANES_PLACE(m, 3) | LANES_PLACE(m, 4) |      \
        LANES_PLACE(m, 5) | LANES_PLACE(m, 6) | LANES_PLACE(m, 7)
#define LANES_PLACES4(m) LANES_PLACES(m), LANES_PLACES(m + 1), LANES_PLACES(m + 2), LANES_PLACES(m + 3)
#define LANES_PLACES16(m) LANES_PLACES4(m), LANES_PLACES4(m + 4), LANES_PLACES4(m + 8), LANES_PLACES4(m + 12)
#define LANES_PLACES64(m)                                                                                    \
    LANES_PLACES16(m), LANES_PLACES16(m + 16), LANES_PLACES16(m + 32), LANES_PLACES16(m + 48)
static const uint64_t lanes_places[256] = {LANES_PLACES64(0u), LANES_PLACES64(64u), LANES_PLACES64(128u),
                                           LANES_PLACES64(192u)};

LANES_INLINE unsigned lanes_put(uint32_t *out, const uint32_t *j, unsigned chosen) {
    __m256i all = _mm256_loadu_si256((const __m256i *)(const void *)j);
    __m256i which =
        _mm256_cvtepu8_epi32(_mm_loadl_epi64((const __m128i *)(const void *)&lanes_places[chosen]));
    _mm256_storeu_si256((__m256i *)(void *)out, _mm256_permutevar8x32_epi32(all, which));
    return (unsigned)__builtin_popcount(chosen);
}

LANES_INLINE void lanes_fill(uint32_t *out, uint32_t i) {
    _mm256_storeu_si256((__m256i *)(void *)out, _mm256_set1_epi32((int)i));
}

LANES_INLINE void lanes_copy(float *to, const float *from, float shift) {
    _mm256_storeu_ps(to, _mm256_add_ps(_mm256_loadu_ps(from), _mm256_set1_ps(shift)));
}

LANES_INLINE void lanes_copy_tagged(uint32_t *to, const uint32_t *from, uint32_t bits) {
    __m256i all = _mm256_loadu_si256((const __m256i *)(const void *)from);
    _mm256_storeu_si256((__m256i *)(void *)to, _mm256_or_si256(all, _mm256_set1_epi32((int)bits)));
}

#endif
