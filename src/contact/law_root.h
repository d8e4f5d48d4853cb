/* SPDX-License-Identifier: BSD-3-Clause */
/* The cube root as arithmetic: a loop that calls law_cbrt vectorises, and all instruction sets give the same bits. */
#ifndef SCREE_CONTACT_LAW_ROOT_H
#define SCREE_CONTACT_LAW_ROOT_H

#include "contact/law_form.h"
#include <stdint.h>
#include <string.h>

/* The cube root of x >= 0, a normal number or 0, within 3e-16: a third of the exponent gives 5 digits in base two, three steps
 * of Halley's iteration the rest. */
LAW_INLINE double law_cbrt(double x) {
    uint64_t bits;
    double root;
    memcpy(&bits, &x, sizeof bits);
    bits = (uint64_t)((uint32_t)(bits >> 32) / 3 + 715094163u) << 32;
    memcpy(&root, &bits, sizeof root);
    for (int k = 0; k < 3; k++) {
        double cube = root * root * root;
        root = root * ((cube + 2.0 * x) / (2.0 * cube + x));
    }
    return x > 0.0 ? root : 0.0;
}

#endif
