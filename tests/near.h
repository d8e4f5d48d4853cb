/* SPDX-License-Identifier: BSD-3-Clause */
/* assert_near: two doubles differ by at most a tolerance, compared in double (assert_float_equal compares in
 * float). Include after cmocka.h. */
#ifndef SCREE_TESTS_NEAR_H
#define SCREE_TESTS_NEAR_H

#include <math.h>

#define assert_near(value, expected, tolerance)                                                              \
    near_check((value), (expected), (tolerance), #value, __FILE__, __LINE__)

static inline void near_check(double value, double expected, double tolerance, const char *text,
                              const char *file, int line) {
    if (fabs(value - expected) <= tolerance)
        return;
    print_error("%s = %.17g, not %.17g within %g\n", text, value, expected, tolerance);
    _fail(file, line);
}

#endif
