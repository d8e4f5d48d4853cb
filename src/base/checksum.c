/* SPDX-License-Identifier: BSD-3-Clause */
/* The hash of a row and the sum of a table. Read checksum.h first. */
#include "base/checksum.h"

#include "base/mix.h"

#include <string.h>

uint64_t checksum_row(uint64_t key, const void *row, size_t bytes) {
    const char *next = row;
    uint64_t hash = mix_bits(mix_bits(key + MIX_GOLDEN) + bytes);
    while (bytes > 0) {
        uint64_t word = 0;
        size_t taken = bytes < sizeof word ? bytes : sizeof word;
        memcpy(&word, next, taken);
        hash = mix_word(hash, word);
        next += taken;
        bytes -= taken;
    }
    return hash;
}

uint64_t checksum_rows(uint64_t first_key, const void *table, size_t rows, size_t bytes) {
    const char *row = table;
    uint64_t sum = 0;
#pragma omp parallel for reduction(+ : sum) if (rows > 100000)
    for (size_t i = 0; i < rows; i++) {
        sum += checksum_row(first_key + i, row + i * bytes, bytes);
    }
    return sum;
}
