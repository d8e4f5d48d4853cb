/* SPDX-License-Identifier: BSD-3-Clause */
/* Lubrication that a lattice leaves out: the resistances of Jeffrey and Onishi (1984) and of a wall, momentum, power, the exact squeeze, the limit. */
#include "tests/test.h"

#include <math.h>
#include <string.h>

#include "physics/fluid/coupling/lubrication.h"
#include "tests/near.h"

/* A film with ln (R / h) = 1 and mu = 1 between a sphere of the radius 1 and one of `ratio`, which may be INFINITY: S and C alone. */
static struct lubrication_parts film_of(double ratio) {
    double reduced = isinf(ratio) ? 1 : ratio / (1 + ratio);
    return (struct lubrication_parts){0, 2 * M_PI * reduced, 1.2 * M_PI * reduced};
}

/* Force and torque on the first by one motion of one end, tangential to a normal along z. */
static void answer(double ratio, int end, double velocity, double spin, double force[6]) {
    struct lubrication_pair pair = {.normal = {0, 0, 1}, .lever = {1, ratio}};
    const struct lubrication_parts parts = film_of(ratio);
    pair.velocity[end][0] = velocity;
    pair.spin[end][1] = spin;
    lubrication_force(&parts, &pair, force);
}

/* The factors of the logarithm in Y^A, Y^B and Y^C, with their dimensions. */
static void the_logarithms_are_those_of_two_spheres(void **state) {
    (void)state;
    for (double l = 0.125; l < 9; l *= 2) {
        double force[6], translation = 24 * M_PI * l * (2 + l + 2 * l * l) / (15 * pow(1 + l, 3)),
                         coupling = 4 * M_PI * l * (4 + l) / (5 * (1 + l) * (1 + l));
        answer(l, 0, 1, 0, force);
        assert_near(force[0], -translation, 1e-13);
        assert_near(fabs(force[4]), coupling, 1e-13);
        answer(l, 1, 1, 0, force);
        assert_near(force[0], translation, 1e-13);
        answer(l, 0, 0, 1, force);
        assert_near(fabs(force[0]), coupling, 1e-13);
        assert_near(force[4], -8 * M_PI * 2 * l / (5 * (1 + l)), 1e-13);
        answer(l, 1, 0, 1, force);
        assert_near(force[4], -M_PI * 4 * l * l / (5 * (1 + l)), 1e-13);
    }
}

/* Goldman, Cox and Brenner: 8/15, 1/10 and 2/5, 2/15. */
static void the_logarithms_are_those_of_a_wall(void **state) {
    double force[6];
    (void)state;
    answer(INFINITY, 0, 1, 0, force);
    assert_near(force[0], -6 * M_PI * 8 / 15, 1e-13);
    assert_near(fabs(force[4]), 8 * M_PI / 10, 1e-13);
    answer(INFINITY, 0, 0, 1, force);
    assert_near(fabs(force[0]), 6 * M_PI * 2 / 15, 1e-13);
    assert_near(force[4], -8 * M_PI * 2 / 5, 1e-13);
    answer(INFINITY, 1, 1, 0, force);
    assert_near(force[0], 6 * M_PI * 8 / 15, 1e-13);
}

/* Numbers that are the same each time, -1 ... 1. */
static double number(unsigned *seed) {
    *seed = *seed * 1664525u + 1013904223u;
    return *seed / 2147483648.0 - 1;
}

/* The other end's view of a pair. */
static struct lubrication_pair turned(const struct lubrication_pair *pair) {
    struct lubrication_pair other = *pair;
    for (int e = 0; e < 2; e++) {
        other.lever[e] = pair->lever[1 - e];
        memcpy(other.velocity[e], pair->velocity[1 - e], sizeof other.velocity[e]);
        memcpy(other.spin[e], pair->spin[1 - e], sizeof other.spin[e]);
    }
    for (int d = 0; d < 3; d++)
        other.normal[d] = -pair->normal[d];
    return other;
}

/* Any motion: forces are opposite, the torques balance the moment of the forces, the power is not positive, and none is left of a rigid rotation. */
static void momentum_stays_and_energy_falls(void **state) {
    const struct lubrication_parts parts = {3, 2, 1.2};
    unsigned seed = 1;
    (void)state;
    for (int round = 0; round < 50; round++) {
        struct lubrication_pair pair = {.normal = {0.36, 0.48, 0.8}, .lever = {1, 1.7}};
        double force[2][6], power = 0;
        for (int k = 0; k < 6; k++) {
            pair.velocity[k / 3][k % 3] = number(&seed);
            pair.spin[k / 3][k % 3] = number(&seed);
        }
        if (round == 0)
            for (int d = 0; d < 3; d++) {
                int e = (d + 1) % 3, f = (d + 2) % 3;
                const double *spin = pair.spin[0];
                pair.spin[1][d] = spin[d];
                pair.velocity[1][d] =
                    pair.velocity[0][d] + 2.7 * (spin[e] * pair.normal[f] - spin[f] * pair.normal[e]);
            }
        struct lubrication_pair other = turned(&pair);
        lubrication_force(&parts, &pair, force[0]);
        lubrication_force(&parts, &other, force[1]);
        for (int d = 0; d < 3; d++) {
            int e = (d + 1) % 3, f = (d + 2) % 3;
            assert_near(force[0][d] + force[1][d], 0, 1e-13);
            assert_near(force[0][3 + d] + force[1][3 + d] +
                            2.7 * (pair.normal[e] * force[1][f] - pair.normal[f] * force[1][e]),
                        0, 1e-13);
        }
        for (int k = 0; k < 6; k++)
            power += force[k / 3][k % 3] * pair.velocity[k / 3][k % 3] +
                     force[k / 3][3 + k % 3] * pair.spin[k / 3][k % 3];
        assert_true(round == 0 ? fabs(power) < 1e-13 : power < 0);
    }
}

/* Brenner's drag (1961) of a sphere that approaches a wall, or of one of two equal ones that approach each other at opposite velocities, over 6 pi mu r; gap over r. */
static double brenner(double gap, bool wall) {
    double a = acosh(1 + (wall ? gap : 0.5 * gap)), sum = 0, square = sinh(a) * sinh(a);
    for (int n = 1; (2 * n + 1) * a < 300; n++) {
        double m = 2 * n + 1, half = 0.5 * m * a;
        double top = wall ? 2 * sinh(m * a) + m * sinh(2 * a) : 4 * cosh(half) * cosh(half) + m * m * square,
               low = wall ? 4 * sinh(half) * sinh(half) - m * m * square : 2 * sinh(m * a) - m * sinh(2 * a);
        sum += n * (n + 1.0) / ((m - 2) * (m + 2)) * (top / low - 1);
    }
    return 4.0 / 3 * sinh(a) * sum;
}

/* Spheres of eight spacings, one before a wall and two: with what the lattice has of it (docs/fluid-method.md) the drag is the exact one. */
static void the_lattice_and_the_rest_are_the_whole_squeeze(void **state) {
    const struct lubrication film = {1, 1, 0.01, 3};
    const double of_lattice[][3] = {
        {1, 0.922, 0.933}, {0.5, 0.741, 0.762}, {0.2, 0.448, 0.447}, {0.1, 0.256, 0.257}};
    (void)state;
    for (int k = 0; k < 4; k++)
        for (int wall = 0; wall < 2; wall++) {
            double gap = of_lattice[k][0], whole = 6 * M_PI * 4 * brenner(gap / 4, wall),
                   rest = wall ? lubrication_of(&film, 4, true, gap).squeeze
                               : 2 * lubrication_of(&film, 2, false, gap).squeeze;
            assert_near((of_lattice[k][1 + wall] * whole + rest) / whole, 1, 0.02);
        }
}

/* It begins at two spacings, grows towards touch, and stays what it is at the roughness. */
static void it_ends_at_two_spacings_and_at_the_roughness(void **state) {
    (void)state;
    for (int dimension = 2; dimension < 4; dimension++) {
        const struct lubrication film = {0.3, 0.5, 0.01, dimension};
        struct lubrication_parts last = lubrication_of(&film, 2, false, 1), now;
        assert_near(last.squeeze + last.slip + last.roll, 0, 0);
        assert_near(lubrication_of(&film, 2, false, 0.999).squeeze, 0, 1e-2);
        for (double gap = 0.9; gap > 0.01; gap *= 0.8, last = now) {
            now = lubrication_of(&film, 2, false, gap);
            assert_true(now.squeeze > last.squeeze && now.slip > last.slip && now.roll > last.roll);
        }
        now = lubrication_of(&film, 2, false, -0.1);
        assert_near(now.squeeze, lubrication_of(&film, 2, false, 0.01).squeeze, 1e-12);
    }
}

/* Twelve neighbours at rest around a grain, in a long step: its motion does not turn round. */
static void the_limit_keeps_a_long_step_stable(void **state) {
    const double mass = 2, dt = 10;
    double after[6] = {1, 2, 3, 0.5, -1, 2};
    (void)state;
    for (int k = 0; k < 12; k++) {
        struct lubrication_pair pair = {.lever = {1, 1},
                                        .lightness = {1 / mass, 1 / mass},
                                        .swing = {2.5 / mass, 2.5 / mass},
                                        .velocity = {{1, 2, 3}},
                                        .spin = {{0.5, -1, 2}}};
        struct lubrication_parts parts = {1e6, 1e6, 1e6};
        double force[6];
        pair.normal[k / 4] = 0.6 * (k % 2 ? 1 : -1);
        pair.normal[(k / 4 + 1) % 3] = 0.8 * (k % 4 < 2 ? 1 : -1);
        lubrication_limit(&parts, &pair, dt);
        lubrication_force(&parts, &pair, force);
        for (int d = 0; d < 6; d++)
            after[d] += dt * force[d] * (d < 3 ? 1 : 2.5) / mass;
    }
    const double before[6] = {1, 2, 3, 0.5, -1, 2};
    double energy[2] = {0};
    for (int d = 0; d < 6; d++) {
        energy[0] += (d < 3 ? 1 : 0.4) * before[d] * before[d];
        energy[1] += (d < 3 ? 1 : 0.4) * after[d] * after[d];
    }
    assert_true(energy[1] < energy[0]);
}

TEST_MAIN(fluid_lubrication, cmocka_unit_test(the_logarithms_are_those_of_two_spheres),
          cmocka_unit_test(the_logarithms_are_those_of_a_wall),
          cmocka_unit_test(momentum_stays_and_energy_falls),
          cmocka_unit_test(the_lattice_and_the_rest_are_the_whole_squeeze),
          cmocka_unit_test(it_ends_at_two_spacings_and_at_the_roughness),
          cmocka_unit_test(the_limit_keeps_a_long_step_stable))
