/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums of what precedes: against the plain loop, with threads. */
#include "tests/test.h"

#include <omp.h>
#include <stdlib.h>

#include "base/random.h"
#include "base/scan.h"

static const size_t lengths[] = {0, 1, 2, 63, 16383, 16384, 16385, 200003};
enum { LENGTHS = sizeof lengths / sizeof lengths[0], LONGEST = 200003 };

struct arrays {
    uint32_t counts[LONGEST + 1];
    size_t sizes[LONGEST + 1];
    size_t expected[LONGEST + 1];
    size_t offsets[LONGEST + 1];
    uint32_t narrow[LONGEST + 1];
};

static struct arrays *make_arrays(size_t n) {
    struct arrays *arrays = calloc(1, sizeof *arrays);
    assert_non_null(arrays);
    struct random_sequence sequence = random_sequence(1, RANDOM_TEST, n);
    for (size_t i = 0; i < n; i++) {
        arrays->counts[i] = (uint32_t)(1000 * random_uniform(&sequence));
        arrays->sizes[i] = arrays->counts[i];
        arrays->expected[i + 1] = arrays->expected[i] + arrays->counts[i];
    }
    return arrays;
}

static void check_length(size_t n) {
    struct arrays *arrays = make_arrays(n);
    size_t total = arrays->expected[n];
    assert_int_equal(scan_counts(arrays->counts, n, arrays->offsets), total);
    assert_memory_equal(arrays->offsets, arrays->expected, (n + 1) * sizeof(size_t));
    assert_int_equal(scan_counts_narrow(arrays->counts, n, arrays->narrow), total);
    for (size_t i = 0; i <= n; i++) {
        assert_int_equal(arrays->narrow[i], arrays->expected[i]);
    }
    assert_int_equal(scan_sizes(arrays->sizes, n, arrays->offsets), total);
    assert_memory_equal(arrays->offsets, arrays->expected, (n + 1) * sizeof(size_t));
    assert_int_equal(scan_sizes(arrays->sizes, n, arrays->sizes), total);
    assert_memory_equal(arrays->sizes, arrays->expected, (n + 1) * sizeof(size_t));
    assert_int_equal(scan_counts_narrow(arrays->counts, n, arrays->counts), total);
    assert_memory_equal(arrays->counts, arrays->narrow, (n + 1) * sizeof(uint32_t));
    free(arrays);
}

/* Marks of one length, about one number in `part`. */
static void check_marks(size_t n, int part) {
    uint8_t *mark = calloc(n + 1, 1);
    uint32_t *list = calloc(n + 1, sizeof *list);
    size_t expected = 0;
    assert_non_null(mark);
    assert_non_null(list);
    struct random_sequence sequence = random_sequence(2, RANDOM_TEST, n);
    for (size_t k = 0; k < n; k++) {
        mark[k] = part * random_uniform(&sequence) < 1 ? (uint8_t)(1 + k % 255) : 0;
        expected += mark[k] != 0;
    }
    assert_int_equal(scan_marked(mark, n, NULL), expected);
    assert_int_equal(scan_marked(mark, n, list), expected);
    for (size_t k = 0, next = 0; k < n; k++) {
        if (mark[k] != 0) {
            assert_int_equal(list[next++], k);
        }
    }
    free(mark);
    free(list);
}

static void equals_the_plain_loop(void **state) {
    (void)state;
    int threads = omp_get_max_threads();
    for (int team = 1; team <= 4; team++) {
        omp_set_num_threads(team);
        for (size_t i = 0; i < LENGTHS; i++) {
            check_length(lengths[i]);
            check_marks(lengths[i], 1);
            check_marks(lengths[i], 50);
        }
    }
    omp_set_num_threads(threads);
}

static void totals_pass_32_bits(void **state) {
    (void)state;
    enum { N = 100000 };
    uint32_t *counts = malloc(N * sizeof *counts);
    size_t *offsets = malloc((N + 1) * sizeof *offsets);
    for (size_t i = 0; i < N; i++) {
        counts[i] = UINT32_MAX;
    }
    assert_true(scan_counts(counts, N, offsets) == (size_t)N * UINT32_MAX);
    assert_true(offsets[N - 1] == (size_t)(N - 1) * UINT32_MAX);
    free(counts);
    free(offsets);
}

static void works_inside_a_parallel_region(void **state) {
    (void)state;
    int wrong = 0;
#pragma omp parallel num_threads(3) reduction(+ : wrong)
    {
        struct arrays *arrays = calloc(1, sizeof *arrays);
        for (size_t i = 0; i < LONGEST; i++) {
            arrays->counts[i] = (uint32_t)omp_get_thread_num() + 1;
        }
        size_t total = scan_counts(arrays->counts, LONGEST, arrays->offsets);
        wrong += total != LONGEST * ((size_t)omp_get_thread_num() + 1);
        wrong += arrays->offsets[LONGEST / 2] != LONGEST / 2 * ((size_t)omp_get_thread_num() + 1);
        free(arrays);
    }
    assert_int_equal(wrong, 0);
}

static void finds_the_first_that_is_no_less(void **state) {
    (void)state;
    static const uint32_t sorted[] = {0, 2, 2, 2, 5, 9, UINT32_MAX};
    enum { COUNT = sizeof sorted / sizeof sorted[0] };
    for (size_t n = 0; n <= COUNT; n++)
        for (size_t value = 0; value < 12; value++) {
            size_t expected = 0;
            while (expected < n && sorted[expected] < value)
                expected++;
            assert_int_equal(scan_first(sorted, n, value), expected);
        }
    assert_int_equal(scan_first(sorted, COUNT, (size_t)UINT32_MAX + 1), COUNT);
}

TEST_MAIN(scan, cmocka_unit_test(equals_the_plain_loop), cmocka_unit_test(totals_pass_32_bits),
          cmocka_unit_test(works_inside_a_parallel_region), cmocka_unit_test(finds_the_first_that_is_no_less))
