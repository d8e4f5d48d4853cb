/* SPDX-License-Identifier: BSD-3-Clause */
/* An order-independent checksum of a table: each row is hashed with its key, and the hashes are added modulo
 * 2^64. Partial sums of any distribution over threads and ranks add up to the same value. */
#ifndef SCREE_BASE_CHECKSUM_H
#define SCREE_BASE_CHECKSUM_H

#include <stddef.h>
#include <stdint.h>

/* The hash of `bytes` bytes together with a 64-bit key (the row number, an id). */
uint64_t checksum_row(uint64_t key, const void *row, size_t bytes);

/* The sum over `rows` rows of `bytes` bytes each, keyed first_key, first_key + 1, ... */
uint64_t checksum_rows(uint64_t first_key, const void *table, size_t rows, size_t bytes);

#endif
