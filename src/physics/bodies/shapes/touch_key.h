/* SPDX-License-Identifier: BSD-3-Clause */
/* The names of points of a contact, by which they are found again in the next step. */
#ifndef SCREE_SHAPES_TOUCH_KEY_H
#define SCREE_SHAPES_TOUCH_KEY_H

#include <stdint.h>

/* What a point is, with its numbers: a corner of A, of B, a crossing of two edges. */
enum touch_kind { TOUCH_NEAREST, TOUCH_CORNER_A, TOUCH_CORNER_B, TOUCH_EDGES };

static inline uint32_t touch_key(enum touch_kind kind, int a, int b) {
    return (uint32_t)kind << 16 | (uint32_t)a << 8 | (uint32_t)b;
}

#endif
