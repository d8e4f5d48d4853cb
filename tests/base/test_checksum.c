/* SPDX-License-Identifier: BSD-3-Clause */
/* Checksums of tables: published values, and what changes them. */
#include "tests/test.h"

#include <string.h>

#include "base/checksum.h"

/* SplitMix64 from its definition: the state moves by the golden ratio, the output is the mixed state. Its
 * first output for seed 0 is published (e220a8397b1dcdaf). A row of no bytes is that mix of the mix. */
static uint64_t splitmix(uint64_t state) {
    state += 0x9e3779b97f4a7c15u;
    state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9u;
    state = (state ^ (state >> 27)) * 0x94d049bb133111ebu;
    return state ^ (state >> 31);
}

static void mix_is_the_published_one(void **state) {
    (void)state;
    assert_true(splitmix(0) == 0xe220a8397b1dcdafu);
    uint64_t word = 0x0123456789abcdefu;
    uint64_t start = splitmix(0) + sizeof word;
    start = splitmix(start - 0x9e3779b97f4a7c15u);
    assert_true(checksum_row(0, &word, sizeof word) == splitmix(start ^ word));
}

static void every_bit_of_row_and_key_counts(void **state) {
    (void)state;
    unsigned char row[29];
    for (size_t i = 0; i < sizeof row; i++) {
        row[i] = (unsigned char)(37 * i);
    }
    uint64_t before = checksum_row(9, row, sizeof row);
    int least = 64, most = 0;
    for (size_t bit = 0; bit < 8 * sizeof row; bit++) {
        row[bit / 8] ^= (unsigned char)(1u << bit % 8);
        int changed = __builtin_popcountll(before ^ checksum_row(9, row, sizeof row));
        least = changed < least ? changed : least;
        most = changed > most ? changed : most;
        row[bit / 8] ^= (unsigned char)(1u << bit % 8);
    }
    for (int bit = 0; bit < 64; bit++) {
        int changed = __builtin_popcountll(before ^ checksum_row(9 ^ (uint64_t)1 << bit, row, sizeof row));
        least = changed < least ? changed : least;
        most = changed > most ? changed : most;
    }
    assert_true(least >= 12 && most <= 52); /* 32 expected, deviation 4 */
}

static void length_counts(void **state) {
    (void)state;
    const char zeros[24] = {0};
    for (size_t a = 0; a <= sizeof zeros; a++) {
        for (size_t b = 0; b < a; b++) {
            assert_true(checksum_row(1, zeros, a) != checksum_row(1, zeros, b));
        }
    }
}

static void parts_add_up_in_any_order(void **state) {
    (void)state;
    enum { ROWS = 150001 };
    static uint64_t table[ROWS][2];
    for (size_t i = 0; i < ROWS; i++) {
        table[i][0] = i * i;
        table[i][1] = ~i;
    }
    uint64_t whole = checksum_rows(100, table, ROWS, sizeof table[0]);
    uint64_t parts = checksum_rows(100 + 777, table[777], ROWS - 777, sizeof table[0]);
    for (size_t i = 777; i-- > 0;) {
        parts += checksum_row(100 + i, table[i], sizeof table[0]);
    }
    assert_true(whole == parts);
    assert_true(checksum_rows(5, table, 0, sizeof table[0]) == 0);
}

static void swapped_rows_are_noticed(void **state) {
    (void)state;
    double table[3] = {1, 2, 3};
    uint64_t before = checksum_rows(0, table, 3, sizeof table[0]);
    double swapped[3] = {2, 1, 3};
    assert_true(before != checksum_rows(0, swapped, 3, sizeof swapped[0]));
    assert_true(before != checksum_rows(1, table, 3, sizeof table[0]));
}

TEST_MAIN(checksum, cmocka_unit_test(mix_is_the_published_one),
          cmocka_unit_test(every_bit_of_row_and_key_counts), cmocka_unit_test(length_counts),
          cmocka_unit_test(parts_add_up_in_any_order), cmocka_unit_test(swapped_rows_are_noticed))
