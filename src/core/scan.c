/* SPDX-License-Identifier: BSD-3-Clause */
/* Two passes over the counts: every thread sums its block, then, knowing the sum of the blocks before its
 * own, writes its offsets. The three public functions differ only in the width of counts and offsets. */
#include "core/scan.h"

#include "core/memory.h"

#include <assert.h>
#include <omp.h>

enum { SCAN_THREADED = 1 << 16 }; /* below so many counts a team of threads costs more time than it saves */

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

static size_t scan_threaded(const struct scan *scan) {
    size_t *sums = memory_allocate_zero((size_t)omp_get_max_threads() + 1, sizeof *sums, "prefix sums");
    size_t total = 0;
#pragma omp parallel
    {
        size_t threads = (size_t)omp_get_num_threads();
        size_t thread = (size_t)omp_get_thread_num();
        size_t begin = scan->n / threads * thread + (thread < scan->n % threads ? thread : scan->n % threads);
        size_t end = begin + scan->n / threads + (thread < scan->n % threads);
        sums[thread + 1] = block_sum(scan, begin, end);
#pragma omp barrier
#pragma omp single
        {
            for (size_t t = 0; t < threads; t++) {
                sums[t + 1] += sums[t];
            }
            total = sums[threads];
        }
        block_write(scan, begin, end, sums[thread]);
    }
    memory_free(sums);
    return total;
}

static size_t run_scan(const struct scan *scan) {
    size_t total;
    if (scan->n >= SCAN_THREADED && !omp_in_parallel() && omp_get_max_threads() > 1) {
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
