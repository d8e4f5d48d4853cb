/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of scene/: decimal numbers as a scene writes them. */
#ifndef SCREE_SCENE_DECIMAL_H
#define SCREE_SCENE_DECIMAL_H

#include <stdbool.h>
#include <stdint.h>

/* Reads the decimal number at the start of `text` into *value, its end into *end; ".inf" is infinity. False
 * for anything else: hexadecimal digits, nan, a number beyond the doubles. */
bool decimal_read(const char *text, const char **end, double *value);

/* The number in [text, end) times 10^decimal, by its exponent, so that 2.3 mm is the double nearest to
 * 0.0023. */
double decimal_shift(const char *text, const char *end, int decimal);

/* Reads a whole number exactly, however it is written (1000000, 1e6, 1.5e3); false if `text` is none. `fits`
 * becomes false, and *value stays undefined, if 64 bits do not hold it. */
bool decimal_whole(const char *text, int64_t *value, bool *fits);

#endif
