/* SPDX-License-Identifier: BSD-3-Clause */
/* The hash of a row and the sum of a table. Read checksum.h first. */
#include "base/checksum.h"

#include <string.h>

/* The finaliser of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014, variant 13 of Stafford): every bit of the
 * input moves every bit of the output. */
static uint64_t mix(uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return bits ^ (bits >> 31);
}

static const uint64_t GOLDEN = 0x9e3779b97f4a7c15u;

uint64_t checksum_row(uint64_t key, const void *row, size_t bytes) {
    const char *next = row;
    uint64_t hash = mix(mix(key + GOLDEN) + bytes);
    while (bytes > 0) {
        uint64_t word = 0;
        size_t taken = bytes < sizeof word ? bytes : sizeof word;
        memcpy(&word, next, taken);
        hash = mix((hash ^ word) + GOLDEN);
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
