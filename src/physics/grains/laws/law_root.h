/* SPDX-License-Identifier: BSD-3-Clause */
/* The cube root as arithmetic: a loop that calls law_cbrt vectorises, and all instruction sets give the same bits. */
#ifndef SCREE_LAWS_LAW_ROOT_H
#define SCREE_LAWS_LAW_ROOT_H

#include "physics/grains/laws/law_form.h"
#include <stdint.h>
#include <string.h>

/* 1 / the cube root of x > 0, a normal number, within 6e-16, without a division: a third of the exponent is within 4 %, twice
 * the series of (1 - h)^(-1/3) in the rest h = 1 - x y^3 gives the other digits. A finite number for 0. */
LAW_INLINE double law_cbrt_inverse(double x) {
    uint64_t bits;
    double y;
    memcpy(&bits, &x, sizeof bits);
    bits = (uint64_t)(1430186164u - (uint32_t)(bits >> 32) / 3) << 32;
    memcpy(&y, &bits, sizeof y);
    for (int k = 0; k < 2; k++) {
        double h = 1.0 - (x * y) * (y * y);
        y += y * h * (1.0 / 3.0 + h * (2.0 / 9.0 + h * (14.0 / 81.0 + h * (35.0 / 243.0))));
    }
    return y;
}

/* The cube root of x >= 0, a normal number or 0, within 7e-16. */
LAW_INLINE double law_cbrt(double x) {
    double y = law_cbrt_inverse(x), square = y * y, root = x * square;
    root -= (root * root * root - x) * square * (1.0 / 3.0);
    return x > 0.0 ? root : 0.0;
}

#endif
