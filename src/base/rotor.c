/* SPDX-License-Identifier: BSD-3-Clause */
/* Rotation by unit quaternions, and the free top. Read rotor.h first. */
#include "base/rotor.h"
#include <math.h>

void rotor_matrix(const double q[4], double turn[9]) {
    double w = q[0], x = q[1], y = q[2], z = q[3];
    turn[0] = (w * w + x * x) - (y * y + z * z);
    turn[1] = 2 * (x * y - w * z);
    turn[2] = 2 * (x * z + w * y);
    turn[3] = 2 * (x * y + w * z);
    turn[4] = (w * w + y * y) - (x * x + z * z);
    turn[5] = 2 * (y * z - w * x);
    turn[6] = 2 * (x * z - w * y);
    turn[7] = 2 * (y * z + w * x);
    turn[8] = (w * w + z * z) - (x * x + y * y);
}

void rotor_turn(const double turn[9], const double v[3], double to[3]) {
    double result[3];
    for (int d = 0; d < 3; d++)
        result[d] = turn[3 * d] * v[0] + turn[3 * d + 1] * v[1] + turn[3 * d + 2] * v[2];
    for (int d = 0; d < 3; d++)
        to[d] = result[d];
}

void rotor_turn_back(const double turn[9], const double v[3], double to[3]) {
    double result[3];
    for (int d = 0; d < 3; d++)
        result[d] = turn[d] * v[0] + turn[3 + d] * v[1] + turn[6 + d] * v[2];
    for (int d = 0; d < 3; d++)
        to[d] = result[d];
}

void rotor_product(const double a[4], const double b[4], double to[4]) {
    double w = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
    double x = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
    double y = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
    double z = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
    to[0] = w;
    to[1] = x;
    to[2] = y;
    to[3] = z;
}

void rotor_velocity(const double turn[9], const double spin[3], const double inertia[3], double w[3]) {
    double own[3];
    rotor_turn_back(turn, spin, own);
    for (int d = 0; d < 3; d++)
        own[d] /= inertia[d];
    rotor_turn(turn, own, w);
}

/* One step of Newton's method towards norm 1: takes back rounding. */
static void unit(double q[4]) {
    double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    for (int k = 0; k < 4; k++)
        q[k] *= 1.5 - 0.5 * square;
}

/* The component of a vector along axis k of the body: column k of rotor_matrix times the vector. */
static double along_own(const double q[4], int k, const double v[3]) {
    double w = q[0], x = q[1 + k], y = q[1 + (k + 1) % 3], z = q[1 + (k + 2) % 3];
    double one = (w * w + x * x) - (y * y + z * z), two = 2 * (x * y + w * z), three = 2 * (x * z - w * y);
    return one * v[k] + two * v[(k + 1) % 3] + three * v[(k + 2) % 3];
}

/* Turns about axis k of the body. */
static void turn_own(double q[4], int k, const double spin[3], double lightness, double h) {
    double by[4] = {0};
    if (lightness == 0)
        return;
    double half = 0.5 * h * along_own(q, k, spin) * lightness;
    by[0] = cos(half);
    by[1 + k] = sin(half);
    rotor_product(q, by, q);
}

void rotor_spin(double q[4], const double w[3], double h) {
    double speed = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    if (speed == 0)
        return;
    double part = sin(0.5 * h * speed) / speed;
    const double by[4] = {cos(0.5 * h * speed), part * w[0], part * w[1], part * w[2]};
    rotor_product(by, q, q);
    unit(q);
}

void rotor_advance(double q[4], const double spin[3], const double inertia[3], double h) {
    double sphere[3];
    for (int d = 0; d < 3; d++)
        sphere[d] = spin[d] / inertia[1];
    double first = 1 / inertia[0] - 1 / inertia[1], last = 1 / inertia[2] - 1 / inertia[1];
    turn_own(q, 0, spin, first, 0.5 * h);
    turn_own(q, 2, spin, last, h);
    turn_own(q, 0, spin, first, 0.5 * h);
    rotor_spin(q, sphere, h);
}
