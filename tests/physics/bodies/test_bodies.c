/* SPDX-License-Identifier: BSD-3-Clause */
/* Rigid bodies: free rotation against a fine integration of Euler's equations, conservation, moments of inertia against closed
 * forms, sums that no order changes. */
#include "tests/test.h"

#include "base/moments.h"
#include "base/rotor.h"
#include "physics/bodies/sums.h"
#include "base/eigen3.h"
#include "base/random.h"

#include <math.h>
#include <string.h>

static const double inertia[3] = {1.0, 1.7, 2.2};

/* dq/dt = 1/2 w q, with w from the constant angular momentum. */
static void slope(const double q[4], const double spin[3], const double moment[3], double to[4]) {
    double turn[9], w[3];
    rotor_matrix(q, turn);
    rotor_velocity(turn, spin, moment, w);
    const double half[4] = {0, 0.5 * w[0], 0.5 * w[1], 0.5 * w[2]};
    rotor_product(half, q, to);
}

/* Runge and Kutta's fourth order. */
static void integrate(double q[4], const double spin[3], const double moment[3], double h, int steps) {
    for (int n = 0; n < steps; n++) {
        double k[4][4], at[4];
        slope(q, spin, moment, k[0]);
        for (int s = 1; s < 4; s++) {
            for (int c = 0; c < 4; c++)
                at[c] = q[c] + (s < 3 ? 0.5 : 1.0) * h * k[s - 1][c];
            slope(at, spin, moment, k[s]);
        }
        for (int c = 0; c < 4; c++)
            q[c] += h / 6 * (k[0][c] + 2 * k[1][c] + 2 * k[2][c] + k[3][c]);
    }
}

static double apart(const double a[4], const double b[4]) {
    double most = 0;
    for (int c = 0; c < 4; c++)
        most = fmax(most, fabs(a[c] - b[c]));
    return most;
}

/* Distance from the fine integration at t = 10 with so many steps. */
static double error_with(int steps, const double moment[3]) {
    const double spin[3] = {0.02, 1.6, 0.3};
    double q[4] = {0.8, 0.0, 0.6, 0.0}, exact[4] = {0.8, 0.0, 0.6, 0.0};
    integrate(exact, spin, moment, 10.0 / 40000, 40000);
    for (int n = 0; n < steps; n++)
        rotor_advance(q, spin, moment, 10.0 / steps);
    return apart(q, exact);
}

static void second_order(void **state) {
    (void)state;
    double coarse = error_with(500, inertia), fine = error_with(1000, inertia);
    assert_true(coarse < 1e-3 && coarse / fine > 3.9 && coarse / fine < 4.1);
}

static void symmetric_tops_exact(void **state) {
    (void)state;
    const double prolate[3] = {0.3, 2, 2}, oblate[3] = {1, 1, 1.8}, sphere[3] = {1, 1, 1};
    assert_true(error_with(7, prolate) < 1e-12);
    assert_true(error_with(7, oblate) < 1e-12);
    assert_true(error_with(3, sphere) < 1e-12);
}

static double energy_of(const double q[4], const double spin[3]) {
    double turn[9], w[3];
    rotor_matrix(q, turn);
    rotor_velocity(turn, spin, inertia, w);
    return 0.5 * (w[0] * spin[0] + w[1] * spin[1] + w[2] * spin[2]);
}

/* The intermediate axis turns over again and again; the energy comes back, the norm stays. */
static void tumbling(void **state) {
    (void)state;
    const double spin[3] = {0.001, 1.7, 0.02};
    double q[4] = {1, 0, 0, 0}, start = energy_of(q, spin), worst = 0, norm = 0;
    int flips = 0;
    bool up = true;
    for (int n = 0; n < 100000; n++) {
        rotor_advance(q, spin, inertia, 0.002);
        double turn[9];
        rotor_matrix(q, turn);
        bool now = turn[4] > 0;
        flips += now != up;
        up = now;
        worst = fmax(worst, fabs(energy_of(q, spin) / start - 1));
        norm = fmax(norm, fabs(sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) - 1));
    }
    assert_true(flips > 5);
    assert_true(worst < 1e-6);
    assert_true(norm < 1e-14);
}

/* Two equal spheres of radius 1, their centres 2 c apart: two caps less than a sphere each. */
static void two_spheres(void **state) {
    (void)state;
    const double c = 0.6;
    const struct clump_sphere sphere[2] = {{{0.3, -c, 0.1}, 1}, {{0.3, c, 0.1}, 1}};
    struct moments moments;
    moments_union(sphere, 2, &moments);
    /* of one half: y from 0 to 1 + c, discs of the squared radius 1 - (y - c)^2 */
    double volume = 0, axial = 0, square = 0;
    const int n = 20000;
    for (int k = 0; k < n; k++) {
        double h = (1 + c) / n, y = (k + 0.5) * h, disc = 1 - (y - c) * (y - c), area = M_PI * disc * h;
        volume += 2 * area;
        axial += 2 * area * disc / 2;
        square += 2 * area * y * y;
    }
    assert_true(fabs(moments.volume / volume - 1) < 1e-5);
    assert_true(fabs(volume / (2 * M_PI * (2.0 / 3 + c - c * c * c / 3)) - 1) < 1e-8);
    assert_true(fabs(moments.gyration[4] / (axial / volume) - 1) < 1e-5);
    assert_true(fabs(moments.gyration[0] / ((axial / 2 + square) / volume) - 1) < 1e-5);
    assert_true(fabs(moments.gyration[8] / ((axial / 2 + square) / volume) - 1) < 1e-5);
    assert_true(fabs(moments.centre[0] - 0.3) < 1e-5 && fabs(moments.centre[1]) < 1e-5 &&
                fabs(moments.centre[2] - 0.1) < 1e-12);
}

/* Spheres that touch: the formula, and the quadrature, which need not know that none overlap. */
static void formula(void **state) {
    (void)state;
    const struct clump_sphere sphere[3] = {{{-2, 0, 0}, 1}, {{0, 0, 0}, 1}, {{1, 2, -2}, 2}};
    struct moments sum, quadrature;
    moments_sum(sphere, 3, &sum);
    moments_union(sphere, 3, &quadrature);
    assert_true(fabs(sum.volume - 40 * M_PI / 3) < 1e-12);
    assert_true(fabs(sum.centre[0] - 0.6) < 1e-14);
    assert_true(fabs(quadrature.volume / sum.volume - 1) < 1e-5);
    for (int k = 0; k < 9; k++)
        assert_true(fabs(quadrature.gyration[k] - sum.gyration[k]) < 1e-4);
    const struct clump_sphere dumbbell[2] = {{{-1, 0, 0}, 1}, {{1, 0, 0}, 1}};
    moments_sum(dumbbell, 2, &sum);
    assert_true(fabs(sum.gyration[0] - 0.4) < 1e-15 && fabs(sum.gyration[4] - 1.4) < 1e-15);
}

/* A box of the edges 1, 2, 3 in 12 triangles, whichever way they run round: volume, centre, a^2 + b^2 over 12. */
static void solid(void **state) {
    (void)state;
    static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int turned = 0; turned < 2; turned++) {
        double corner[12][9];
        for (int t = 0; t < 12; t++)
            for (int c = 0; c < 3; c++) {
                int place = c == 0 ? 0 : (c == 1) != turned ? 1 + t % 2 : 2 + t % 2;
                int at = side[t / 2][place];
                corner[t][3 * c] = 10 + (at & 1);
                corner[t][3 * c + 1] = -5 + 2 * (at >> 1 & 1);
                corner[t][3 * c + 2] = 3 * (at >> 2);
            }
        struct moments moments;
        moments_solid(corner, 12, &moments);
        assert_true(fabs(moments.volume - 6) < 1e-13);
        assert_true(fabs(moments.centre[0] - 10.5) < 1e-13 && fabs(moments.centre[1] + 4) < 1e-13 &&
                    fabs(moments.centre[2] - 1.5) < 1e-13);
        const double want[9] = {13.0 / 12, 0, 0, 0, 10.0 / 12, 0, 0, 0, 5.0 / 12};
        for (int k = 0; k < 9; k++)
            assert_true(fabs(moments.gyration[k] - want[k]) < 1e-13);
    }
}

static void axes(void **state) {
    (void)state;
    struct random_sequence random = random_sequence(5, RANDOM_TEST, 0);
    for (int round = 0; round < 200; round++) {
        double q[4], turn[9], matrix[9], value[3], found[9], back[4], norm = 0;
        const double moment[3] = {1, round % 3 == 0 ? 1 : 1.5, 2};
        for (int c = 0; c < 4; c++) {
            q[c] = random_normal(&random);
            norm += q[c] * q[c];
        }
        for (int c = 0; c < 4; c++)
            q[c] /= sqrt(norm);
        rotor_matrix(q, turn);
        for (int d = 0; d < 3; d++)
            for (int e = 0; e < 3; e++) {
                matrix[3 * d + e] = 0;
                for (int k = 0; k < 3; k++)
                    matrix[3 * d + e] += turn[3 * d + k] * moment[k] * turn[3 * e + k];
            }
        eigen3_axes(matrix, value, found);
        moments_quaternion(found, back);
        rotor_matrix(back, turn);
        for (int k = 0; k < 9; k++)
            assert_true(fabs(turn[k] - found[k]) < 1e-13);
        for (int d = 0; d < 3; d++) {
            double image[3];
            const double axis[3] = {found[d], found[3 + d], found[6 + d]};
            assert_true(fabs(value[d] - moment[d]) < 1e-13);
            rotor_turn(matrix, axis, image);
            for (int e = 0; e < 3; e++)
                assert_true(fabs(image[e] - value[d] * axis[e]) < 1e-13);
        }
    }
}

/* The same bits forwards, backwards, and in two parts. */
static void any_order(void **state) {
    enum { TERMS = 500 };
    (void)state;
    struct random_sequence random = random_sequence(7, RANDOM_TEST, 1);
    const struct sums_units units = sums_units_of(3.0, 0.2, 1e-3);
    double sum[3][SUMS_ORDERED] = {{0}}, part[SUMS_ORDERED] = {0}, plain[SUMS_PLAIN] = {0}, term[TERMS][6];
    for (int k = 0; k < TERMS; k++)
        for (int c = 0; c < 6; c++)
            term[k][c] = random_normal(&random) * exp(10 * random_normal(&random));
    for (int k = 0; k < TERMS; k++) {
        const double *last = term[TERMS - 1 - k];
        sums_add(sum[0], true, units, term[k], term[k] + 3);
        sums_add(sum[1], true, units, last, last + 3);
        sums_add(k % 3 ? sum[2] : part, true, units, term[k], term[k] + 3);
        sums_add(plain, false, units, term[k], term[k] + 3);
    }
    for (int c = 0; c < SUMS_ORDERED; c++)
        sum[2][c] += part[c];
    assert_memory_equal(sum[0], sum[1], sizeof sum[0]);
    assert_memory_equal(sum[0], sum[2], sizeof sum[0]);
    double force[3], torque[3];
    sums_value(sum[0], true, units, force, torque);
    for (int d = 0; d < 3; d++) {
        assert_true(fabs(force[d] - plain[d]) < 1e-9 * fabs(plain[d]) + 1e-9);
        assert_true(fabs(torque[d] - plain[3 + d]) < 1e-9 * fabs(plain[3 + d]) + 1e-9);
    }
}

/* What is left of large forces that cancel is exact down to 2^-100 of the unit. */
static void small_forces_count(void **state) {
    (void)state;
    const struct sums_units units = sums_units_of(3.0, 0.2, 1e-3);
    const double large[3] = {ldexp(1.7, units.force), 0, ldexp(-5, units.force)}, none[3] = {0};
    const double less[3] = {-large[0], 0, -large[2]},
                 small[3] = {ldexp(1.5, units.force - 90), ldexp(-1.25, units.force - 50),
                             ldexp(1, units.force - 100)};
    double sum[SUMS_ORDERED] = {0}, force[3], torque[3];
    sums_add(sum, true, units, large, none);
    sums_add(sum, true, units, small, none);
    sums_add(sum, true, units, less, none);
    sums_value(sum, true, units, force, torque);
    assert_memory_equal(force, small, sizeof force);
    assert_true(torque[0] == 0 && torque[1] == 0 && torque[2] == 0);
}

TEST_MAIN(bodies, cmocka_unit_test(second_order), cmocka_unit_test(symmetric_tops_exact),
          cmocka_unit_test(tumbling), cmocka_unit_test(two_spheres), cmocka_unit_test(formula),
          cmocka_unit_test(solid), cmocka_unit_test(axes), cmocka_unit_test(any_order),
          cmocka_unit_test(small_forces_count))
