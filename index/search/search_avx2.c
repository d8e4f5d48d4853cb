/* SPDX-License-Identifier: BSD-3-Clause */
/* The search of search_rows.h for the instructions AVX2. */
#include "index/search/search.h"

#if defined(__x86_64__)
#include "index/search/lanes_avx2.h"
#else
#include "index/search/lanes_plain.h"
#endif
#include "index/search/search_rows.h"

LANES_TARGET void search_avx2(const struct levels *levels, const struct searches *searches,
                              const struct index_view *view, size_t first, size_t last,
                              struct index_sink *sink) {
    search_rows(levels, searches, view, first, last, sink);
}
