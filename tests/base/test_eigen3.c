/* SPDX-License-Identifier: BSD-3-Clause */
/* Eigenvalues and axes of matrices that are made from known ones. */
#include "tests/test.h"

#include "base/eigen3.h"
#include "base/random.h"

#include <math.h>

/* The rotation of a random unit quaternion. */
static void turn_draw(struct random_sequence *draws, double turn[9]) {
    double q[4], square = 0;
    for (int k = 0; k < 4; k++) {
        q[k] = random_normal(draws);
        square += q[k] * q[k];
    }
    double w = q[0], x = q[1], y = q[2], z = q[3], s = 2 / square;
    const double matrix[9] = {1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),
                              s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x),
                              s * (x * z - w * y),     s * (y * z + w * x),     1 - s * (x * x + y * y)};
    for (int k = 0; k < 9; k++)
        turn[k] = matrix[k];
}

static void matrix_make(const double value[3], const double turn[9], double matrix[9]) {
    for (int d = 0; d < 3; d++)
        for (int e = 0; e < 3; e++) {
            matrix[3 * d + e] = 0;
            for (int k = 0; k < 3; k++)
                matrix[3 * d + e] += turn[3 * d + k] * value[k] * turn[3 * e + k];
        }
}

/* The axes are those of a right-handed rotation and give the matrix back; the values are in order. */
static void values_and_axes_are_found(void **state) {
    (void)state;
    const double cases[][3] = {{1, 2, 3}, {-1, 0, 5}, {2, 2, 3}, {1, 4, 4},
                               {7, 7, 7}, {0, 0, 0},  {0, 0, 1}, {-3, -2, 1e-9}};
    struct random_sequence draws = random_sequence(5, RANDOM_TEST, 0);
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++)
        for (int trial = 0; trial < 50; trial++) {
            double turn[9], matrix[9], value[3], axes[9], again[9];
            turn_draw(&draws, turn);
            matrix_make(cases[c], turn, matrix);
            eigen3_axes(matrix, value, axes);
            matrix_make(value, axes, again);
            double scale = fmax(fabs(cases[c][0]), fabs(cases[c][2]));
            for (int k = 0; k < 3; k++)
                assert_true(fabs(value[k] - cases[c][k]) <= 1e-14 * scale);
            for (int k = 0; k < 9; k++)
                assert_true(fabs(again[k] - matrix[k]) <= 1e-14 * scale);
            double hand = axes[0] * (axes[4] * axes[8] - axes[5] * axes[7]) -
                          axes[1] * (axes[3] * axes[8] - axes[5] * axes[6]) +
                          axes[2] * (axes[3] * axes[7] - axes[4] * axes[6]);
            assert_true(fabs(hand - 1) <= 1e-14);
        }
}

static void the_largest_value_alone_agrees(void **state) {
    (void)state;
    const double cases[][3] = {{1, 2, 3}, {0, 0, 1}, {0, 1, 2}, {2, 2, 3},
                               {7, 7, 7}, {0, 0, 0}, {1, 4, 4}, {0, 1, 1}};
    struct random_sequence draws = random_sequence(6, RANDOM_TEST, 0);
    double worst = 0;
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++)
        for (int trial = 0; trial < 50; trial++) {
            double turn[9], m[9];
            turn_draw(&draws, turn);
            matrix_make(cases[c], turn, m);
            const double six[6] = {m[0], m[4], m[8], m[1], m[2], m[5]};
            double off = fabs(eigen3_largest(six) - cases[c][2]) / fmax(cases[c][2], 1);
            worst = fmax(worst, off);
            assert_true(off <= (cases[c][1] == cases[c][2] ? 3e-8 : 1e-14));
        }
    print_message("largest error %.2g\n", worst);
}

TEST_MAIN(eigen3, cmocka_unit_test(values_and_axes_are_found),
          cmocka_unit_test(the_largest_value_alone_agrees))
