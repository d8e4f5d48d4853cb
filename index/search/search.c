/* SPDX-License-Identifier: BSD-3-Clause */
/* Selects the compiled form of the search (search_rows.h). */
#include "index/search/search.h"

void search_run(const struct levels *levels, const struct searches *searches, const struct index_view *view,
                size_t first, size_t last, struct index_sink *sink) {
    if (levels->instructions == INDEX_AVX512) {
        search_avx512(levels, searches, view, first, last, sink);
    } else if (levels->instructions == INDEX_AVX2) {
        search_avx2(levels, searches, view, first, last, sink);
    } else {
        search_plain(levels, searches, view, first, last, sink);
    }
}
