/* Eight lanes of AVX-512 (registers of 256 bits, with masks and compression). See lanes_plain.h. */
#ifndef SCREE_INDEX_LANES_AVX512_H
#define SCREE_INDEX_LANES_AVX512_H

#include "index/index.h"

#include <immintrin.h>

#define LANES_TARGET __attribute__((target("avx512f,avx512vl,avx2,fma,popcnt,bmi")))
#define LANES_INLINE                                                                                         \
    static inline __attribute__((always_inline, target("avx512f,avx512vl,avx2,fma,popcnt,bmi")))

enum { LANES = 8 };

struct lanes_row {
    __m256 x, y, z, r, certain;
};

LANES_INLINE struct lanes_row lanes_row(const float x[3], float r, float certain) {
    return (struct lanes_row){_mm256_set1_ps(x[0]), _mm256_set1_ps(x[1]), _mm256_set1_ps(x[2]),
                              _mm256_set1_ps(r), _mm256_set1_ps(certain)};
}

LANES_INLINE unsigned lanes_test(const struct lanes_row *row, const float *x, const float *y, const float *z,
                                 const float *r, unsigned *doubtful) {
    __m256 dx = _mm256_sub_ps(_mm256_loadu_ps(x), row->x);
    __m256 dy = _mm256_sub_ps(_mm256_loadu_ps(y), row->y);
    __m256 dz = _mm256_sub_ps(_mm256_loadu_ps(z), row->z);
    __m256 c = _mm256_add_ps(_mm256_loadu_ps(r), row->r);
    __m256 square = _mm256_fmadd_ps(dx, dx, _mm256_fmadd_ps(dy, dy, _mm256_mul_ps(dz, dz)));
    __m256 cutoff = _mm256_mul_ps(c, c);
    __mmask8 possible = _mm256_cmp_ps_mask(square, cutoff, _CMP_LE_OQ);
    *doubtful = _mm256_mask_cmp_ps_mask(possible, square, _mm256_mul_ps(cutoff, row->certain), _CMP_NLE_UQ);
    return possible;
}

/* Compressed in the register: compression straight into memory is slow on some CPUs. */
LANES_INLINE unsigned lanes_put(uint32_t *out_i, uint32_t *out_j, uint32_t i, const uint32_t *j,
                                unsigned chosen) {
    __m256i all = _mm256_loadu_si256((const __m256i *)(const void *)j);
    _mm256_storeu_si256((__m256i *)(void *)out_j, _mm256_maskz_compress_epi32((__mmask8)chosen, all));
    _mm256_storeu_si256((__m256i *)(void *)out_i, _mm256_set1_epi32((int)i));
    return (unsigned)__builtin_popcount(chosen);
}

LANES_INLINE void lanes_copy(float *to, const float *from, float shift) {
    _mm256_storeu_ps(to, _mm256_add_ps(_mm256_loadu_ps(from), _mm256_set1_ps(shift)));
}

LANES_INLINE void lanes_copy_tagged(uint32_t *to, const uint32_t *from, uint32_t bits) {
    __m256i all = _mm256_loadu_si256((const __m256i *)(const void *)from);
    _mm256_storeu_si256((__m256i *)(void *)to, _mm256_or_si256(all, _mm256_set1_epi32((int)bits)));
}

#endif
