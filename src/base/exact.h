/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums of doubles without rounding: a fixed-point number as wide as all doubles, so that the sum does not
 * depend on the order of its terms, nor on the way that the terms were shared out among threads and ranks
 * (the long accumulator of Kulisch). Words of two sums may be added one by one, with any integer sum over
 * ranks. */
#ifndef SCREE_BASE_EXACT_H
#define SCREE_BASE_EXACT_H

#include <stddef.h>
#include <stdint.h>

/* Words of 32 bits from 2^-1074 on, one word for carries, and one that counts terms that are not finite. */
enum { EXACT_WORDS = 68 };

/* All words zero: the empty sum. One sum holds up to 2^30 terms, the terms of added sums included. */
struct exact {
    int64_t word[EXACT_WORDS];
};

/* Adds a term. */
void exact_add(struct exact *sum, double term);

/* Adds another sum. */
void exact_join(struct exact *sum, const struct exact *other);

/* The sum as a double: relative error below 2^-51, the same bits for the same terms. NaN if a term was not
 * finite. */
double exact_value(const struct exact *sum);

#endif
