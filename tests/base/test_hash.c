/* SPDX-License-Identifier: BSD-3-Clause */
/* The hash table beside a plain search, filled by one thread and by several. */
#include "tests/test.h"

#include <stdbool.h>

#include "base/hash.h"

enum { NUMBERS = 5000 };

/* How many numbers of the chain have the key of `number`; that number must be one of them. */
static size_t found(const struct hash *table, const uint64_t *key, uint64_t wanted, size_t number) {
    size_t count = 0;
    bool here = false;
    for (uint32_t n = hash_first(table, wanted); n != HASH_END; n = table->next[n]) {
        assert_true(n < NUMBERS);
        here = here || n == number;
        count += key[n] == wanted;
    }
    assert_true(here || number >= NUMBERS);
    return count;
}

/* Keys of which some occur several times: small ones, ones that differ in their top bits only, and negative ones. */
static void keys_make(uint64_t key[NUMBERS]) {
    for (size_t n = 0; n < NUMBERS; n++) {
        uint64_t k = n % 1700;
        key[n] = n % 3 == 0 ? k : n % 3 == 1 ? k << 48 : (uint64_t) - (int64_t)k;
    }
}

static void check_all(const struct hash *table, const uint64_t *key) {
    for (size_t n = 0; n < NUMBERS; n++) {
        size_t expected = 0;
        for (size_t m = 0; m < NUMBERS; m++)
            expected += key[m] == key[n];
        assert_int_equal(found(table, key, key[n], n), expected);
    }
    assert_int_equal(found(table, key, 123456789, NUMBERS), 0);
}

static void all_numbers_of_a_key_are_found(void **state) {
    (void)state;
    static uint64_t key[NUMBERS];
    struct hash table = {0};
    keys_make(key);
    for (int round = 0; round < 2; round++) { /* the second uses the memory of the first */
        hash_start(&table, NUMBERS, "test");
        assert_true(table.room >= NUMBERS);
        assert_int_equal(found(&table, key, key[0], NUMBERS), 0);
        for (uint32_t n = 0; n < NUMBERS; n++)
            hash_put(&table, key[n], n);
        check_all(&table, key);
    }
    size_t bytes = hash_memory(&table);
    hash_start(&table, 1, "test");
    assert_int_equal(found(&table, key, key[0], NUMBERS), 0);
    assert_int_equal(hash_memory(&table), bytes);
    hash_free(&table);
    assert_int_equal(hash_memory(&table), 0);
}

static void threads_fill_a_table_together(void **state) {
    (void)state;
    static uint64_t key[NUMBERS];
    struct hash table = {0};
    keys_make(key);
    hash_start(&table, NUMBERS, "test");
#pragma omp parallel for schedule(static, 1) num_threads(4)
    for (uint32_t n = 0; n < NUMBERS; n++)
        hash_put(&table, key[n], n);
    check_all(&table, key);
    hash_free(&table);
}

/* Chains stay short for keys in a row, for ids and for cells. */
static void chains_are_short(void **state) {
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        struct hash table = {0};
        size_t longest = 0;
        hash_start(&table, NUMBERS, "test");
        for (uint32_t n = 0; n < NUMBERS; n++) {
            const int64_t cell[3] = {n % 17 - 8, n / 17 % 17 - 8, n / 289 - 8};
            uint64_t key = kind == 0 ? n : kind == 1 ? (uint64_t)(n / 70) << 32 | n % 70 : mix_cell(3, cell);
            size_t length = 1;
            for (uint32_t m = hash_first(&table, key); m != HASH_END; m = table.next[m])
                length++;
            longest = length > longest ? length : longest;
            hash_put(&table, key, n);
        }
        assert_true(longest <= 8);
        hash_free(&table);
    }
}

TEST_MAIN(hash, cmocka_unit_test(all_numbers_of_a_key_are_found),
          cmocka_unit_test(threads_fill_a_table_together), cmocka_unit_test(chains_are_short))
