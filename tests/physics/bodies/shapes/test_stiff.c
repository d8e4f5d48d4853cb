/* SPDX-License-Identifier: BSD-3-Clause */
/* The stiffness of contacts: closed forms of a box, differences of touch.h, the largest eigenvalue of six rows. */
#include "tests/test.h"

#include "base/eigen6.h"
#include "physics/bodies/shapes/stiff.h"
#include "tests/near.h"
#include "tests/physics/bodies/shapes/solid_by_hand.h"

/* A matrix with the eigenvalues 1 ... 6, in turned axes: H diag H, H = 1 - 2 u u^T. */
static void eigenvalue(void **state) {
    const double u[6] = {0.1, -0.5, 0.3, 0.7, 0.2, sqrt(1 - 0.01 - 0.25 - 0.09 - 0.49 - 0.04)};
    double matrix[36];
    (void)state;
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++) {
            double sum = 0;
            for (int k = 0; k < 6; k++)
                sum += ((i == k) - 2 * u[i] * u[k]) * (k + 1) * ((k == j) - 2 * u[k] * u[j]);
            matrix[6 * i + j] = sum;
        }
    assert_near(eigen6_largest(matrix), 6, 1e-14);
    for (int k = 0; k < 36; k++)
        matrix[k] = k % 7 == 0 ? -3 : 0;
    assert_near(eigen6_largest(matrix), -3, 1e-14);
}

/* A cube of edge 1: moments 1/6 over mass. A corner of the core at c sqrt(3), c = 1/2: 1 + 3 c^2 x 6. Four corners on a plane: each has
 * (1/4)^(4/6) of the fifth power, and a tilt about an edge's direction moves all of them by c. */
static void cube(void **state) {
    const double gyration[3] = {1.0 / 6, 1.0 / 6, 1.0 / 6};
    struct by_hand cube;
    double seat[STIFF_KINDS];
    (void)state;
    assert_true(by_hand_box(&cube, 1, 1, 1, 0.01));
    assert_near(stiff_corner(&cube.core, gyration), 5.5, 1e-12);
    stiff_seat(&cube.core, 0.01, gyration, seat);
    assert_near(seat[0], 5 * pow(4, -2.0 / 3) * 4 * 0.25 * 6, 1e-9);
    assert_near(seat[STIFF_DAMPED], 5.5, 1e-12);
    assert_true(seat[STIFF_ACROSS] >= 5.5 && seat[STIFF_ACROSS] < 12);
    solid_free(&cube.core);
}

/* The energy d^2 / 2 of a rock on a plane, moved by a step along one axis and turned about another one. */
static double energy_at(const struct by_hand *rock, const double move[6], double height) {
    struct by_hand there = *rock;
    struct features features;
    double q[4] = {1, 0.5 * move[3], 0.5 * move[4], 0.5 * move[5]}, norm = 0;
    for (int k = 0; k < 4; k++)
        norm += q[k] * q[k];
    for (int k = 0; k < 4; k++)
        q[k] /= sqrt(norm);
    by_hand_pose(&there, q, rock->posed.rounding);
    if (!touch_plane(&there.posed, (double[3]){0, 0, 1}, height + move[2], &features))
        return 0;
    double d = feature_overlap(features.feature, features.count);
    return 0.5 * d * d;
}

/* Second differences of the energy: all of it but the slope of the normal force, which the small overlap makes small. */
static void differences(void **state) {
    const double gyration[3] = {0.2, 0.3, 0.45}, step = 1e-7, height = 0.4 + 0.05 - 1e-4;
    struct by_hand box;
    struct features features;
    struct stiff stiff;
    (void)state;
    assert_true(by_hand_box(&box, 1, 0.6, 0.8, 0.05));
    assert_true(touch_plane(&box.posed, (double[3]){0, 0, 1}, height, &features));
    struct stiff_side side = {.turn = box.turn, .gyration = {0.2, 0.3, 0.45}};
    stiff_find(features.feature, features.count, &side, 1, &stiff);
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++) {
            double second = 0;
            for (int corner = 0; corner < 4; corner++) {
                double move[6] = {0}, one = corner & 1 ? 1 : -1, two = corner & 2 ? 1 : -1;
                move[i] += one * step / (i < 3 ? 1 : sqrt(gyration[i - 3]));
                move[j] += two * step / (j < 3 ? 1 : sqrt(gyration[j - 3]));
                second += one * two * energy_at(&box, move, height) / (4 * step * step);
            }
            assert_true(fabs(stiff.matrix[STIFF_ALONG][6 * i + j] - second) < 0.02);
        }
    solid_free(&box.core);
}

TEST_MAIN(stiff, cmocka_unit_test(eigenvalue), cmocka_unit_test(cube), cmocka_unit_test(differences))
