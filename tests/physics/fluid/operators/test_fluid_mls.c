/* SPDX-License-Identifier: BSD-3-Clause */
/* Moving least squares: exact for polynomials of their order, errors and orders on displaced particles, and what takes their
 * place where a particle has too few neighbours. */
#include "tests/test.h"

#include "tests/physics/fluid/fluid_cloud.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The gradient of a square by moving least squares of second order: sum b (x_j - x_i)^p (x_j - x_i)^q, in spacings. */
static double squares(const struct fluid_cloud *c, const struct weights *w) {
    double worst = 0;
    size_t n = (size_t)c->dimension;
    for (size_t row = 0; row < w->rows; row++) {
        double sum[3][3][3] = {{{0}}}, apart[3];
        for (size_t e = w->start[row]; e < w->start[row + 1]; e++) {
            fluid_cloud_apart(c, w, row, e, apart);
            for (size_t k = 0; k < n; k++)
                for (size_t p = 0; p < n; p++)
                    for (size_t q = 0; q < n; q++)
                        sum[k][p][q] += weights_vector(w, e)[k] * apart[p] * apart[q];
        }
        for (size_t k = 0; k < n; k++)
            for (size_t p = 0; p < n; p++)
                for (size_t q = 0; q < n; q++)
                    worst = fmax(worst, fabs(sum[k][p][q]) / c->spacing);
    }
    return worst;
}

static void test_mls(void **state) {
    static const double reach[] = {0, 2.3, 2.6, 3.1, 3.6};
    (void)state;
    for (int dimension = 2; dimension <= 3; dimension++)
        for (int order = 1; order <= (dimension == 2 ? 4 : 3); order++) {
            struct fluid_cloud c;
            fluid_cloud_make(&c, dimension, dimension == 2 ? 16 : 8, reach[order] + 0.3 * (dimension == 3),
                             0.4, 2);
            struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_MLS + order, false);
            assert_int_equal(w.poor, 0);
            assert_true(fluid_cloud_identities(&c, &w) < 1e-9);
            assert_true((squares(&c, &w) < 1e-9) == (order > 1));
            weights_free(&w);
            fluid_cloud_free(&c);
        }
}

/* Eight neighbours are enough for order 2 and not for order 3, four not even for corrected operators. */
static void test_poor(void **state) {
    struct fluid_cloud c;
    (void)state;
    fluid_cloud_make(&c, 2, 10, 1.6, 0, 1);
    struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_MLS + 2, true);
    assert_int_equal(w.poor, 0);
    weights_free(&w);
    w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_MLS + 3, true);
    assert_int_equal(w.poor, w.rows);
    assert_true(fluid_cloud_identities(&c, &w) < 1e-11 && squares(&c, &w) < 1e-11);
    assert_true(fabs(w.condition[7] - 1) < 1e-9);
    weights_free(&w);
    fluid_cloud_free(&c);
    fluid_cloud_make(&c, 2, 10, 1.2, 0, 1);
    w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_MLS + 2, true);
    assert_int_equal(w.poor, w.rows);
    assert_true(w.condition[7] == 0);
    weights_free(&w);
    fluid_cloud_free(&c);
}

/* Measured figures of a prototype, at 64 a side, for order 4; order 2 has a rate of 2 and 1.5. */
static void test_mls_convergence(void **state) {
    (void)state;
    struct fluid_cloud_errors fourth = fluid_cloud_errors(2, 64, 3.6, 0.2, WEIGHTS_MLS + 4),
                              coarse = fluid_cloud_errors(2, 32, 2.6, 0.2, WEIGHTS_MLS + 2),
                              fine = fluid_cloud_errors(2, 128, 2.6, 0.2, WEIGHTS_MLS + 2);
    print_message("order 4: %.3g %.3g; order 2: %.3g %.3g, then %.3g %.3g\n", fourth.gradient,
                  fourth.laplacian, coarse.gradient, coarse.laplacian, fine.gradient, fine.laplacian);
    assert_true(fourth.gradient < 4e-5 && fourth.laplacian < 5e-5);
    assert_true(log2(coarse.gradient / fine.gradient) / 2 >= 1.9);
    assert_true(log2(coarse.laplacian / fine.laplacian) / 2 >= 1.3);
}

TEST_MAIN(fluid_mls, cmocka_unit_test(test_mls), cmocka_unit_test(test_poor),
          cmocka_unit_test(test_mls_convergence))
