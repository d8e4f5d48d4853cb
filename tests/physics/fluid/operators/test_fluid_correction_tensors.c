/* SPDX-License-Identifier: BSD-3-Clause */
/* The tensors of one particle: the identities of its weights, closed forms on a square of eight, and neighbours that are too few. */
#include "tests/test.h"

#include <math.h>

#include "base/random.h"
#include "tests/near.h"
#include "physics/fluid/operators/correction_tensors.h"
#include "physics/fluid/operators/kernel.h"

/* The neighbour that stands at `apart` = x_j - x_i, of volume 1. */
static struct correction_tensors_neighbour neighbour_at(const struct kernel *kernel, const double apart[3]) {
    struct correction_tensors_neighbour n = {0};
    n.distance = sqrt(apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2]);
    n.strength = kernel_slope(kernel, n.distance);
    n.value = kernel_value(kernel, n.distance);
    for (int d = 0; d < 3; d++)
        n.e[d] = -apart[d] / n.distance;
    return n;
}

/* Random neighbours, all on one side, too: b is exact for linear and w for quadratic functions. */
static void weights_are_exact(void **state) {
    (void)state;
    for (int dimension = 2; dimension <= 3; dimension++)
        for (int case_number = 0; case_number < 20; case_number++) {
            enum { COUNT = 24 };
            struct random_sequence random = random_sequence(11, RANDOM_TEST, (uint64_t)case_number);
            struct kernel kernel = kernel_make(KERNEL_WENDLAND_C2, 2, dimension);
            struct correction_tensors_neighbour neighbour[COUNT];
            struct tensors tensors;
            double apart[COUNT][3] = {{0}}, b[3], first[3][3] = {{0}}, second[3][3] = {{0}}, mean[3] = {0};
            for (int k = 0; k < COUNT; k++) {
                for (int d = 0; d < dimension; d++)
                    apart[k][d] = 2 * random_uniform(&random) - (case_number < 10 || d > 0);
                neighbour[k] = neighbour_at(&kernel, apart[k]);
            }
            assert_true(correction_tensors_make(&tensors, neighbour, COUNT, dimension));
            assert_true(tensors.condition >= 1 - 1e-12);
            for (int k = 0; k < COUNT; k++) {
                double w = correction_tensors_weigh(&tensors, &neighbour[k], dimension, b);
                for (int p = 0; p < dimension; p++) {
                    mean[p] += w * apart[k][p];
                    for (int q = 0; q < dimension; q++) {
                        first[p][q] += b[p] * apart[k][q];
                        second[p][q] += w * apart[k][p] * apart[k][q];
                    }
                }
            }
            for (int p = 0; p < dimension; p++) {
                assert_near(mean[p], 0, 1e-8);
                for (int q = 0; q < dimension; q++) {
                    assert_near(first[p][q], p == q, 1e-10);
                    assert_near(second[p][q], 2 * (p == q), 1e-8);
                }
            }
        }
}

/* The eight neighbours of a square lattice: M = -(2 s1 + 2 sqrt(2) s2) 1 of the strengths s1 at 1 and s2 at sqrt(2), so G is the
 * inverse number, b of the neighbour at (1, 0) is -s1 G along x, and |M| |G| / 2 is 1. */
static void eight_have_a_closed_form(void **state) {
    struct kernel kernel = kernel_make(KERNEL_QUINTIC, 2.5, 2);
    struct correction_tensors_neighbour neighbour[8];
    struct tensors tensors;
    double s1 = kernel_slope(&kernel, 1), s2 = kernel_slope(&kernel, sqrt(2));
    double g = -1 / (2 * s1 + 2 * sqrt(2) * s2), b[3], edge, corner;
    int count = 0;
    (void)state;
    for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++)
            if (x != 0 || y != 0)
                neighbour[count++] = neighbour_at(&kernel, (double[3]){x, y, 0});
    assert_true(correction_tensors_make(&tensors, neighbour, 8, 2));
    assert_near(tensors.condition, 1, 1e-13);
    for (int p = 0; p < 2; p++) {
        assert_near(tensors.rest[p], 0, 1e-12);
        for (int q = 0; q < 2; q++)
            assert_near(tensors.gradient[p][q], p == q ? g : 0, 1e-12 * g);
    }
    edge = correction_tensors_weigh(&tensors, &neighbour[4], 2, b); /* (1, 0) */
    assert_near(b[0], -s1 * g, 1e-12);
    assert_near(b[1], 0, 1e-12);
    corner = correction_tensors_weigh(&tensors, &neighbour[7], 2, b); /* (1, 1) */
    assert_near(b[0], -s2 * g / sqrt(2), 1e-12);
    assert_near(edge + 2 * corner, 1, 1e-12); /* sum of w x^2 = 2 */
}

/* Without corrections w = -2 s / r and b = s e. */
static void standard_ones_are_those_of_the_kernel(void **state) {
    struct kernel kernel = kernel_make(KERNEL_WENDLAND_C4, 2, 3);
    struct correction_tensors_neighbour n = neighbour_at(&kernel, (double[3]){0.3, -0.6, 0.2});
    struct tensors tensors;
    double b[3];
    (void)state;
    correction_tensors_standard(&tensors, 3);
    assert_near(correction_tensors_weigh(&tensors, &n, 3, b), -2 * n.strength / n.distance, 1e-12);
    for (int d = 0; d < 3; d++)
        assert_near(b[d], n.strength * n.e[d], 1e-13);
    assert_true(tensors.condition == 0);
}

/* On a line M is singular; with four neighbours in a cross it is not, but S is. Both get the standard operators. */
static void too_few_are_noticed(void **state) {
    struct kernel kernel = kernel_make(KERNEL_WENDLAND_C2, 2, 2);
    struct correction_tensors_neighbour line[6], cross[4];
    struct tensors tensors;
    (void)state;
    for (int k = 0; k < 6; k++)
        line[k] = neighbour_at(&kernel, (double[3]){0.3 * (k - 2.5), 0, 0});
    for (int k = 0; k < 4; k++)
        cross[k] = neighbour_at(&kernel, (double[3]){k == 0   ? 1
                                                     : k == 1 ? -1
                                                              : 0,
                                                     k == 2   ? 1
                                                     : k == 3 ? -1
                                                              : 0,
                                                     0});
    assert_false(correction_tensors_make(&tensors, line, 6, 2));
    assert_true(tensors.gradient[0][0] == 1 && tensors.gradient[0][1] == 0 && tensors.condition == 0);
    for (int k = 0; k < 6; k++) /* nearly on a line */
        line[k] = neighbour_at(&kernel, (double[3]){0.3 * (k - 2.5), 1e-7 * (k % 3), 0});
    assert_false(correction_tensors_make(&tensors, line, 6, 2));
    assert_false(correction_tensors_make(&tensors, cross, 4, 2));
    assert_true(tensors.laplacian[0] == 1 && tensors.condition == 0);
    assert_false(correction_tensors_make(&tensors, cross, 0, 2));
}

TEST_MAIN(fluid_correction_tensors, cmocka_unit_test(weights_are_exact),
          cmocka_unit_test(eight_have_a_closed_form), cmocka_unit_test(standard_ones_are_those_of_the_kernel),
          cmocka_unit_test(too_few_are_noticed))
