/* SPDX-License-Identifier: BSD-3-Clause */
/* Exact sums: closed forms, cancellation that rounding would hide, and no dependence on order or division. */
#include "tests/test.h"

#include "base/exact.h"
#include "base/random.h"

#include <float.h>
#include <math.h>
#include <string.h>

static double sum_of(const double *term, size_t n) {
    struct exact sum = {0};
    for (size_t k = 0; k < n; k++)
        exact_add(&sum, term[k]);
    return exact_value(&sum);
}

static void single_terms(void **state) {
    (void)state;
    const double term[] = {0,       1,       -1,       0.1,        -1e300, 3e-310, -DBL_TRUE_MIN,
                           DBL_MIN, DBL_MAX, -DBL_MAX, 123456789.5};
    for (size_t k = 0; k < sizeof term / sizeof term[0]; k++)
        assert_true(sum_of(&term[k], 1) == term[k]);
}

static void cancellation(void **state) {
    (void)state;
    const double big[] = {1e300, 1, -1e300, 1e-300, -1};
    assert_true(sum_of(big, 5) == 1e-300);
    const double tiny[] = {1, DBL_TRUE_MIN, -1};
    assert_true(sum_of(tiny, 3) == DBL_TRUE_MIN);
    const double down[] = {-1, 0x1p-60, -0x1p-60, -2};
    assert_true(sum_of(down, 4) == -3);
    const double none[] = {0.1, 0.7, -0.7, -0.1};
    assert_true(sum_of(none, 4) == 0);
}

static void not_finite(void **state) {
    (void)state;
    const double infinite[] = {1, INFINITY}, nan[] = {NAN, 2};
    assert_true(isnan(sum_of(infinite, 2)));
    assert_true(isnan(sum_of(nan, 2)));
    struct exact whole = {{0}}, part = {{0}};
    exact_add(&whole, 1);
    exact_add(&part, -INFINITY);
    exact_join(&whole, &part); /* parts of one sum: what one has seen holds of all */
    assert_true(isnan(exact_value(&whole)));
}

/* Many terms of all sizes, forwards, backwards and in two parts: the same bits; near the sum in long double.
 */
static void any_order(void **state) {
    enum { TERMS = 20000 };
    static double term[TERMS], back[TERMS];
    struct random_sequence random = random_sequence(7, RANDOM_TEST, 1);
    long double near = 0, sizes = 0;
    (void)state;
    for (size_t k = 0; k < TERMS; k++) {
        term[k] = ldexp(random_uniform(&random) - 0.5, (int)(60 * random_uniform(&random)) - 30);
        back[TERMS - 1 - k] = term[k];
        near += term[k];
        sizes += fabsl(term[k]);
    }
    double forwards = sum_of(term, TERMS), backwards = sum_of(back, TERMS);
    struct exact part[2] = {{{0}}, {{0}}};
    for (size_t k = 0; k < TERMS; k++)
        exact_add(&part[k % 3 == 0], term[k]);
    exact_join(&part[0], &part[1]);
    double joined = exact_value(&part[0]);
    assert_memory_equal(&forwards, &backwards, sizeof forwards);
    assert_memory_equal(&forwards, &joined, sizeof forwards);
    assert_true(fabsl(near - forwards) <= TERMS * LDBL_EPSILON * sizes);
}

TEST_MAIN(exact, cmocka_unit_test(single_terms), cmocka_unit_test(cancellation), cmocka_unit_test(not_finite),
          cmocka_unit_test(any_order))
