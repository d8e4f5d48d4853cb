/* SPDX-License-Identifier: BSD-3-Clause */
/* Sorting items by rank. Ranks: 1 */
#include "tests/test.h"

#include "kernel/comm/rank_groups.h"
#include "base/memory.h"
#include "base/random.h"

enum { ITEMS = 500, SIZE = 40 };

/* Every item once, in groups of increasing rank, in order inside a group. */
static void compare(const int *rank, size_t n, int size) {
    struct groups groups;
    rank_groups_make(&groups, rank, n, size);
    assert_int_equal(groups.start[groups.count], n);
    size_t seen = 0;
    for (size_t g = 0; g < groups.count; g++) {
        assert_int_equal(groups.start[g], seen);
        assert_true(g == 0 || groups.rank[g] > groups.rank[g - 1]);
        assert_true(groups.start[g + 1] > seen);
        for (; seen < groups.start[g + 1]; seen++) {
            assert_int_equal(rank[groups.item[seen]], groups.rank[g]);
            assert_true(seen == groups.start[g] || groups.item[seen] > groups.item[seen - 1]);
        }
    }
    rank_groups_free(&groups);
    assert_null(groups.item);
}

static void random_ranks(void **state) {
    (void)state;
    for (uint64_t turn = 0; turn < 50; turn++) {
        struct random_sequence sequence = random_sequence(turn, RANDOM_TEST, 0);
        size_t n = (size_t)(ITEMS * random_uniform(&sequence));
        double span = SIZE * random_uniform(&sequence);
        int rank[ITEMS];
        for (size_t k = 0; k < n; k++)
            rank[k] = (int)(span * random_uniform(&sequence));
        compare(rank, n, SIZE);
    }
}

static void ends_of_the_range(void **state) {
    (void)state;
    compare(NULL, 0, SIZE);
    compare((int[]){SIZE - 1}, 1, SIZE);
    compare((int[]){SIZE - 1, 0, SIZE - 1, 0}, 4, SIZE);
}

/* As many ranks as items, out of very many; memory follows the items. */
static void many_ranks(void **state) {
    (void)state;
    enum { RANKS = 100000000 };
    int rank[ITEMS];
    struct random_sequence sequence = random_sequence(7, RANDOM_TEST, 0);
    for (size_t k = 0; k < ITEMS; k++)
        rank[k] = (int)(RANKS * random_uniform(&sequence));
    size_t before = memory_in_use();
    memory_peak_reset();
    compare(rank, ITEMS, RANKS);
    assert_true(memory_peak() - before < 200 * ITEMS);
}

TEST_MAIN(groups, cmocka_unit_test(random_ranks), cmocka_unit_test(ends_of_the_range),
          cmocka_unit_test(many_ranks))
