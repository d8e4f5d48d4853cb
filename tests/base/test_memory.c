/* SPDX-License-Identifier: BSD-3-Clause */
/* Memory: alignment, contents, counts, and sizes that cannot be. */
#include "tests/test.h"

#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "base/memory.h"

static const size_t sizes[] = {0,      1, 63, 64, 65, 1000, 1 << 20, (4 << 20) - 1, 4 << 20, (4 << 20) + 1,
                               9000001};
enum { SIZES = sizeof sizes / sizeof sizes[0] };

static void arrays_are_aligned_and_padded(void **state) {
    (void)state;
    char *arrays[SIZES];
    for (size_t i = 0; i < SIZES; i++) {
        arrays[i] = memory_allocate(sizes[i], 1, "test");
        assert_non_null(arrays[i]);
        assert_int_equal((uintptr_t)arrays[i] % MEMORY_ALIGNMENT, 0);
        memset(arrays[i], (int)i, sizes[i] + MEMORY_ALIGNMENT);
    }
    for (size_t i = 0; i < SIZES; i++) {
        for (size_t j = 0; j < sizes[i] + MEMORY_ALIGNMENT; j++) {
            if (arrays[i][j] != (char)i) {
                fail_msg("array %zu overwritten at %zu", i, j);
            }
        }
        memory_free(arrays[i]);
    }
    memory_free(NULL);
}

static void zero_means_zero(void **state) {
    (void)state;
    for (size_t i = 0; i < SIZES; i++) {
        char *dirty = memory_allocate(sizes[i], 1, "test");
        memset(dirty, 0x5a, sizes[i] + MEMORY_ALIGNMENT);
        memory_free(dirty);
        char *array = memory_allocate_zero(sizes[i], 1, "test");
        for (size_t j = 0; j < sizes[i] + MEMORY_ALIGNMENT; j++) {
            if (array[j] != 0) {
                fail_msg("size %zu: byte %zu is not zero", sizes[i], j);
            }
        }
        memory_free(array);
    }
}

static void fill_pattern(uint32_t *array, size_t begin, size_t end) {
    for (size_t i = begin; i < end; i++) {
        array[i] = (uint32_t)(i * 2654435761u);
    }
}

static void check_pattern(const uint32_t *array, size_t end) {
    for (size_t i = 0; i < end; i++) {
        if (array[i] != (uint32_t)(i * 2654435761u)) {
            fail_msg("entry %zu lost", i);
        }
    }
}

static void resize_keeps_the_contents(void **state) {
    (void)state;
    static const size_t counts[] = {10, 1000, 999, 600, 3000000, 2000000, 5000000, 70, 0, 5};
    uint32_t *array = NULL;
    size_t count = 0;
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        array = memory_resize(array, counts[i], sizeof *array, "test");
        assert_int_equal((uintptr_t)array % MEMORY_ALIGNMENT, 0);
        check_pattern(array, count < counts[i] ? count : counts[i]);
        fill_pattern(array, 0, counts[i]);
        memset((char *)(array + counts[i]), 0, MEMORY_ALIGNMENT);
        count = counts[i];
    }
    memory_free(array);
}

static void bytes_are_counted(void **state) {
    (void)state;
    size_t before = memory_in_use();
    void *small = memory_allocate(1000, 8, "test");
    size_t with_small = memory_in_use();
    assert_in_range(with_small - before, 8000, 8000 + 3 * MEMORY_ALIGNMENT);
    void *large = memory_allocate(1 << 20, 8, "test");
    size_t with_large = memory_in_use();
    assert_in_range(with_large - with_small, 8 << 20, (8 << 20) + (8 << 10));
    assert_true(memory_peak() >= with_large);
    large = memory_resize(large, 1000, 8, "test");
    assert_in_range(memory_in_use() - with_small, 8000, 8000 + 3 * MEMORY_ALIGNMENT);
    assert_true(memory_peak() >= with_large);
    memory_free(large);
    memory_free(small);
    assert_int_equal(memory_in_use(), before);
}

static void counting_is_safe_with_threads(void **state) {
    (void)state;
    size_t before = memory_in_use();
#pragma omp parallel for num_threads(4) schedule(dynamic)
    for (int i = 0; i < 2000; i++) {
        void *array = memory_allocate((size_t)i, 8, "test");
        array = memory_resize(array, (size_t)(2000 - i), 8, "test");
        memory_free(array);
    }
    assert_int_equal(memory_in_use(), before);
}

static void peak_resident_follows_use(void **state) {
    (void)state;
    size_t before = memory_peak_resident();
    assert_true(before > 0);
    size_t bytes = before + (32 << 20);
    memory_free(memory_allocate_zero(bytes, 1, "test"));
    assert_true(memory_peak_resident() >= bytes);
}

static void leave(int status) {
    _exit(40 + status);
}

/* Whether asking for count * size bytes ends a child through the abort hook. */
static void ask_too_much(size_t count, size_t size) {
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        error_set_abort(0, leave);
        memory_allocate(count, size, "too much");
        _exit(0);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 40 + ERROR_SYSTEM);
}

static void impossible_sizes_end_the_program(void **state) {
    (void)state;
    ask_too_much(SIZE_MAX / 2, 3);
    ask_too_much(SIZE_MAX - 10, 1);
}

TEST_MAIN(memory, cmocka_unit_test(arrays_are_aligned_and_padded), cmocka_unit_test(zero_means_zero),
          cmocka_unit_test(resize_keeps_the_contents), cmocka_unit_test(bytes_are_counted),
          cmocka_unit_test(counting_is_safe_with_threads), cmocka_unit_test(peak_resident_follows_use),
          cmocka_unit_test(impossible_sizes_end_the_program))
