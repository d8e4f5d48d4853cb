/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads decimal numbers and shifts their point without rounding. Read decimal.h first. */
#include "data/scene/decimal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool decimal_read(const char *text, const char **end, double *value) {
    const char *digits = text + (*text == '-' || *text == '+');
    if (strncmp(digits, ".inf", 4) == 0) {
        *value = *text == '-' ? -INFINITY : INFINITY;
        *end = digits + 4;
        return true;
    }
    if (!((*digits >= '0' && *digits <= '9') || *digits == '.') ||
        (digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X')))
        return false;
    char *after;
    *value = strtod(text, &after);
    *end = after;
    return after != text && isfinite(*value);
}

double decimal_shift(const char *text, const char *end, int decimal) {
    char copy[128];
    size_t mantissa = strcspn(text, "eE ");
    mantissa = text + mantissa < end ? mantissa : (size_t)(end - text);
    long exponent = text + mantissa < end ? strtol(text + mantissa + 1, NULL, 10) : 0;
    snprintf(copy, sizeof(copy), "%.*se%ld", (int)(mantissa < 100 ? mantissa : 100), text,
             exponent + decimal);
    return strtod(copy, NULL);
}

/* The digits of a decimal number, its point left out, times 10^exponent. */
struct decimal {
    bool negative;
    int64_t digits; /* zeros at the end are in the exponent */
    long exponent;
};

/* Takes a text apart; false if it is no decimal number, or has more digits than 64 bits hold. */
static bool split_decimal(const char *text, struct decimal *decimal) {
    double value;
    const char *end;
    if (!decimal_read(text, &end, &value) || *end != '\0' || isinf(value))
        return false;
    *decimal = (struct decimal){.negative = *text == '-'};
    bool point = false;
    long zeros = 0; /* not yet in the digits */
    for (text += *text == '-' || *text == '+'; *text && *text != 'e' && *text != 'E'; text++) {
        if (*text == '.') {
            point = true;
            continue;
        }
        decimal->exponent -= point;
        zeros++;
        if (*text == '0')
            continue;
        for (; zeros > 0; zeros--)
            if (__builtin_mul_overflow(decimal->digits, 10, &decimal->digits))
                return false;
        if (__builtin_add_overflow(decimal->digits, *text - '0', &decimal->digits))
            return false;
    }
    decimal->exponent += zeros + (*text ? strtol(text + 1, NULL, 10) : 0);
    return true;
}

bool decimal_whole(const char *text, int64_t *value, bool *fits) {
    struct decimal decimal;
    double real;
    const char *end;
    *fits = true;
    if (!split_decimal(text, &decimal)) { /* infinite, of too many digits, or none at all */
        *fits = false;
        return decimal_read(text, &end, &real) && *end == '\0' && (isinf(real) || fabs(real) >= 9e15);
    }
    *value = decimal.negative ? -decimal.digits : decimal.digits;
    for (; *value != 0 && decimal.exponent > 0 && *fits; decimal.exponent--)
        *fits = !__builtin_mul_overflow(*value, 10, value);
    return *value == 0 || decimal.exponent >= 0;
}
