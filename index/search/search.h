/* SPDX-License-Identifier: BSD-3-Clause */
/* The search itself: one function for each instruction set, the same loop (search_rows.h) over different
 * vector instructions (lanes_*.h). For levels.c and tests alone. */
#ifndef SCREE_INDEX_SEARCH_SEARCH_H
#define SCREE_INDEX_SEARCH_SEARCH_H

#include "index/grids/levels_parts.h"

/* Emits the pairs that these searches find for the rows [first, last), by the levels' instruction set. Any
 * number of threads at once. */
void search_run(const struct levels *levels, const struct searches *searches, const struct index_view *view,
                size_t first, size_t last, struct index_sink *sink);

/* search_run by one instruction set, which the CPU must have. */
void search_plain(const struct levels *levels, const struct searches *searches, const struct index_view *view,
                  size_t first, size_t last, struct index_sink *sink);
void search_avx2(const struct levels *levels, const struct searches *searches, const struct index_view *view,
                 size_t first, size_t last, struct index_sink *sink);
void search_avx512(const struct levels *levels, const struct searches *searches,
                   const struct index_view *view, size_t first, size_t last, struct index_sink *sink);

/* The widest instruction set that this CPU has, an enum index_instructions. */
int search_instructions(void);

#endif
