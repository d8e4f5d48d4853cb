/* Eight lanes of AVX2. See lanes_plain.h. */
#ifndef SCREE_INDEX_LANES_AVX2_H
#define SCREE_INDEX_LANES_AVX2_H

#include "index/index.h"

#include <immintrin.h>

#define LANES_TARGET __attribute__((target("avx2,fma,popcnt,bmi")))
#define LANES_INLINE static inline __attribute__((always_inline, target("avx2,fma,popcnt,bmi")))

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
    __m256 sure = _mm256_cmp_ps(square, _mm256_mul_ps(cutoff, row->certain), _CMP_LE_OQ);
    __m256 possible = _mm256_cmp_ps(square, cutoff, _CMP_LE_OQ);
    *doubtful = (unsigned)_mm256_movemask_ps(_mm256_andnot_ps(sure, possible));
    return (unsigned)_mm256_movemask_ps(possible);
}

/* Moves the chosen of four words to the front, by a table of byte shuffles. */
LANES_INLINE __m128i lanes_compress4(__m128i all, unsigned chosen) {
    static const uint8_t lane[16][4] = {
        {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {2, 0, 0, 0}, {0, 2, 0, 0},
        {1, 2, 0, 0}, {0, 1, 2, 0}, {3, 0, 0, 0}, {0, 3, 0, 0}, {1, 3, 0, 0}, {0, 1, 3, 0},
        {2, 3, 0, 0}, {0, 2, 3, 0}, {1, 2, 3, 0}, {0, 1, 2, 3},
    };
    int packed;
    __builtin_memcpy(&packed, lane[chosen], sizeof packed);
    __m128i which = _mm_cvtepu8_epi32(_mm_cvtsi32_si128(packed));
    return _mm_castps_si128(_mm_permutevar_ps(_mm_castsi128_ps(all), which));
}

LANES_INLINE unsigned lanes_put(uint32_t *out, const uint32_t *j, unsigned chosen) {
    __m128i low = _mm_loadu_si128((const __m128i *)(const void *)j);
    __m128i high = _mm_loadu_si128((const __m128i *)(const void *)(j + 4));
    unsigned lower = (unsigned)__builtin_popcount(chosen & 15);
    _mm_storeu_si128((__m128i *)(void *)out, lanes_compress4(low, chosen & 15));
    _mm_storeu_si128((__m128i *)(void *)(out + lower), lanes_compress4(high, chosen >> 4));
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
