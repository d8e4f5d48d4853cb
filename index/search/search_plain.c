/* SPDX-License-Identifier: BSD-3-Clause */
/* The search of search_rows.h for any processor, and the test for the instructions of this processor. Read
 * search.h first. */
#include "index/search/search.h"

#include "index/search/lanes_plain.h"
#include "index/search/search_rows.h"

void search_plain(const struct levels *levels, const struct searches *searches, const struct index_view *view,
                  size_t first, size_t last, struct index_sink *sink) {
    search_rows(levels, searches, view, first, last, sink);
}

int search_instructions(void) {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")) {
        bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl");
        return wide ? INDEX_AVX512 : INDEX_AVX2;
    }
#endif
    return INDEX_PLAIN;
}
