/* SPDX-License-Identifier: BSD-3-Clause */
/* Adds a double to the accumulator, carries, and rounds once at the end. Read exact.h first. */
#include "base/exact.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { EXACT_STRANGE = EXACT_WORDS - 1, EXACT_DIGITS = EXACT_WORDS - 1 };
static const uint64_t low_bits = 0xffffffffu;

void exact_add(struct exact *sum, double term) {
    uint64_t bits;
    memcpy(&bits, &term, sizeof bits);
    uint64_t exponent = bits >> 52 & 0x7ff, digits = bits & 0xfffffffffffffu;
    if (exponent == 0x7ff) {
        sum->word[EXACT_STRANGE]++;
        return;
    }
    if (exponent > 0) {
        digits |= (uint64_t)1 << 52;
        exponent--;
    }
    unsigned turn = exponent % 32;
    uint64_t low = (digits & low_bits) << turn, high = (digits >> 32) << turn;
    int64_t part[3] = {(int64_t)(low & low_bits), (int64_t)((low >> 32) + (high & low_bits)),
                       (int64_t)(high >> 32)};
    int64_t *word = sum->word + exponent / 32;
    int64_t sign = bits >> 63 ? -1 : 1;
    for (int k = 0; k < 3; k++)
        word[k] += sign * part[k];
}

void exact_join(struct exact *sum, const struct exact *other) {
    for (int k = 0; k < EXACT_WORDS; k++)
        sum->word[k] += other->word[k];
}

/* Brings all digits but the last into [0, 2^32). The last digit has the sign of the sum. */
static void carry(struct exact *sum) {
    for (int k = 0; k < EXACT_DIGITS - 1; k++) {
        int64_t rest = (int64_t)((uint64_t)sum->word[k] & low_bits);
        sum->word[k + 1] += (sum->word[k] - rest) / ((int64_t)1 << 32);
        sum->word[k] = rest;
    }
}

double exact_value(const struct exact *sum) {
    struct exact s = *sum;
    double value = 0;
    if (s.word[EXACT_STRANGE] != 0)
        return NAN;
    carry(&s);
    bool negative = s.word[EXACT_DIGITS - 1] < 0;
    if (negative) {
        for (int k = 0; k < EXACT_DIGITS; k++)
            s.word[k] = -s.word[k];
        carry(&s);
    }
    for (int k = EXACT_DIGITS - 1; k >= 0; k--)
        value += ldexp((double)s.word[k], 32 * k - 1074);
    return negative ? -value : value;
}
