/* SPDX-License-Identifier: BSD-3-Clause */
/* Two passes over the counts: every thread sums its block, then, knowing the sum of the blocks before its
 * own, writes its offsets. The functions of counts differ only in the width of counts and offsets. */
#include "base/scan.h"

#include "base/memory.h"

#include <assert.h>
#include <omp.h>
#include <stdbool.h>

enum { SCAN_THREADED = 1 << 14 }; /* below so many counts a team of threads costs more time than it saves */

/* Exactly one of counts32 and counts64 is set, and one of offsets32 and offsets64. */
struct scan {
    const uint32_t *counts32;
    const size_t *counts64;
    uint32_t *offsets32;
    size_t *offsets64;
    size_t n;
};

static size_t block_sum(const struct scan *scan, size_t begin, size_t end) {
    size_t sum = 0;
    if (scan->counts32 != NULL) {
        for (size_t i = begin; i < end; i++) {
            sum += scan->counts32[i];
        }
    } else {
        for (size_t i = begin; i < end; i++) {
            sum += scan->counts64[i];
        }
    }
    return sum;
}

static void block_write(const struct scan *scan, size_t begin, size_t end, size_t sum) {
    if (scan->offsets32 != NULL) {
        for (size_t i = begin; i < end; i++) {
            uint32_t count = scan->counts32[i];
            scan->offsets32[i] = (uint32_t)sum;
            sum += count;
        }
    } else if (scan->counts32 != NULL) {
        for (size_t i = begin; i < end; i++) {
            scan->offsets64[i] = sum;
            sum += scan->counts32[i];
        }
    } else {
        for (size_t i = begin; i < end; i++) {
            size_t count = scan->counts64[i];
            scan->offsets64[i] = sum;
            sum += count;
        }
    }
}

/* The part of a thread of the calling team. */
static void thread_part(size_t n, size_t *begin, size_t *end) {
    size_t threads = (size_t)omp_get_num_threads();
    size_t thread = (size_t)omp_get_thread_num();
    *begin = n / threads * thread + (thread < n % threads ? thread : n % threads);
    *end = *begin + n / threads + (thread < n % threads);
}

/* The sum of the blocks before that of the calling thread; sums[0] is 0, and `total` becomes the sum of all blocks. The
 * whole team calls. */
static size_t sums_before(size_t *sums, size_t own, size_t *total) {
    sums[omp_get_thread_num() + 1] = own;
#pragma omp barrier
#pragma omp single
    {
        for (int t = 0; t < omp_get_num_threads(); t++) {
            sums[t + 1] += sums[t];
        }
        *total = sums[omp_get_num_threads()];
    }
    return sums[omp_get_thread_num()];
}

static bool threaded(size_t n) {
    return n >= SCAN_THREADED && !omp_in_parallel() && omp_get_max_threads() > 1;
}

static size_t *sums_make(void) {
    return memory_allocate_zero((size_t)omp_get_max_threads() + 1, sizeof(size_t), "prefix sums");
}

static size_t scan_threaded(const struct scan *scan) {
    size_t *sums = sums_make();
    size_t total = 0;
#pragma omp parallel
    {
        size_t begin, end;
        thread_part(scan->n, &begin, &end);
        size_t before = sums_before(sums, block_sum(scan, begin, end), &total);
        block_write(scan, begin, end, before);
    }
    memory_free(sums);
    return total;
}

static size_t run_scan(const struct scan *scan) {
    size_t total;
    if (threaded(scan->n)) {
        total = scan_threaded(scan);
    } else {
        total = block_sum(scan, 0, scan->n);
        block_write(scan, 0, scan->n, 0);
    }
    if (scan->offsets32 != NULL) {
        scan->offsets32[scan->n] = (uint32_t)total;
    } else {
        scan->offsets64[scan->n] = total;
    }
    return total;
}

size_t scan_counts(const uint32_t *counts, size_t n, size_t *offsets) {
    return run_scan(&(struct scan){.counts32 = counts, .offsets64 = offsets, .n = n});
}

size_t scan_sizes(const size_t *counts, size_t n, size_t *offsets) {
    return run_scan(&(struct scan){.counts64 = counts, .offsets64 = offsets, .n = n});
}

size_t scan_counts_narrow(const uint32_t *counts, size_t n, uint32_t *offsets) {
    size_t total = run_scan(&(struct scan){.counts32 = counts, .offsets32 = offsets, .n = n});
    assert(total <= UINT32_MAX);
    return total;
}

static size_t marks_count(const uint8_t *mark, size_t begin, size_t end) {
    size_t count = 0;
    for (size_t k = begin; k < end; k++) {
        count += mark[k] != 0;
    }
    return count;
}

static void marks_write(const uint8_t *mark, size_t begin, size_t end, uint32_t *list) {
    for (size_t k = begin; k < end; k++) {
        if (mark[k] != 0) {
            *list++ = (uint32_t)k;
        }
    }
}

size_t scan_marked(const uint8_t *mark, size_t n, uint32_t *list) {
    if (!threaded(n)) {
        if (list != NULL) {
            marks_write(mark, 0, n, list);
        }
        return marks_count(mark, 0, n);
    }
    size_t *sums = sums_make();
    size_t total = 0;
#pragma omp parallel
    {
        size_t begin, end;
        thread_part(n, &begin, &end);
        size_t before = sums_before(sums, marks_count(mark, begin, end), &total);
        if (list != NULL) {
            marks_write(mark, begin, end, list + before);
        }
    }
    memory_free(sums);
    return total;
}
