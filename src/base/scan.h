/* SPDX-License-Identifier: BSD-3-Clause */
/* Exclusive prefix sums: counts become offsets. The middle step of count, scan, fill. */
#ifndef SCREE_BASE_SCAN_H
#define SCREE_BASE_SCAN_H

#include <stddef.h>
#include <stdint.h>

/* offsets[i] = counts[0] + ... + counts[i - 1] for i = 0 ... n: n + 1 entries are written; the last one is
 * the total, which is returned. `counts` has n entries. The function opens its own team of threads; inside a
 * parallel region the function runs on the calling thread. The result does not depend on the number of
 * threads. In place (offsets == counts) is allowed where the types agree and the array has room for n + 1
 * entries. */
size_t scan_counts(const uint32_t *counts, size_t n, size_t *offsets);

/* As scan_counts, for size_t counts. */
size_t scan_sizes(const size_t *counts, size_t n, size_t *offsets);

/* As scan_counts, with 32-bit offsets: the total must be below 2^32 (asserted). The true total is returned: a
 * caller that cannot know the total beforehand compares the total with UINT32_MAX. */
size_t scan_counts_narrow(const uint32_t *counts, size_t n, uint32_t *offsets);

/* Writes the numbers k < n with mark[k] != 0 to `list`, in ascending order, and returns how many there are; list NULL:
 * only counts. n is below 2^32. Threads as in scan_counts. */
size_t scan_marked(const uint8_t *mark, size_t n, uint32_t *list);

/* The first k < n with sorted[k] >= value, by halves; n: there is none. `sorted` ascends. */
static inline size_t scan_first(const uint32_t *sorted, size_t n, size_t value) {
    size_t low = 0, high = n;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (sorted[middle] < value)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

#endif
