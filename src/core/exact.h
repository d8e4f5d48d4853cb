/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums of doubles without rounding: a fixed-point number as wide as all doubles, so that the sum does not
 * depend on the order of its terms, nor on how they were shared out among threads and ranks (the long
 * accumulator of Kulisch). Words of two sums may be added one by one, with any integer sum over ranks. */
#ifndef SCREE_CORE_EXACT_H
#define SCREE_CORE_EXACT_H

#include <stddef.h>
#include <stdint.h>

/* 32 bits a word from 2^-1074 on, one for carries, and a count of terms that are not finite. */
enum { EXACT_WORDS = 68 };

/* All zero: the empty sum. Good for 2^30 terms, those of added sums counted. */
struct exact {
    int64_t word[EXACT_WORDS];
};

/* Adds a term. */
void exact_add(struct exact *sum, double term);

/* Adds another sum. */
void exact_join(struct exact *sum, const struct exact *other);

/* The sum as a double: relative error below 2^-51, the same for the same terms. NaN if one was not finite. */
double exact_value(const struct exact *sum);

#endif
