/* SPDX-License-Identifier: BSD-3-Clause */
/* Forces and torques as sums of whole numbers. Read sums.h first. */
#include "physics/bodies/sums.h"
#include <math.h>

/* The unit of the first word is 2^-12 of the unit of the sum, of each further word 2^-32 of the one before. */
enum { FIRST_BITS = 12, WORD_BITS = 32 };

struct sums_units sums_units_of(double mass, double radius, double dt) {
    struct sums_units units;
    frexp(mass * radius / (dt * dt), &units.force);
    frexp(radius, &units.torque);
    units.torque += units.force;
    return units;
}

static void number_add(double word[SUMS_WORDS], int unit, double value) {
    double left = ldexp(value, FIRST_BITS - unit);
    for (int k = 0; k < SUMS_WORDS; k++) {
        double whole = trunc(left);
        word[k] += whole;
        left = ldexp(left - whole, WORD_BITS);
    }
}

static double number_value(const double word[SUMS_WORDS], int unit) {
    double sum = 0;
    for (int k = SUMS_WORDS - 1; k >= 0; k--)
        sum += ldexp(word[k], unit - FIRST_BITS - WORD_BITS * k);
    return sum;
}

void sums_add(double *sum, bool ordered, struct sums_units units, const double force[3],
              const double torque[3]) {
    for (int d = 0; d < 3 && !ordered; d++) {
        sum[d] += force[d];
        sum[3 + d] += torque[d];
    }
    for (int d = 0; d < 3 && ordered; d++) {
        number_add(sum + SUMS_WORDS * d, units.force, force[d]);
        number_add(sum + SUMS_WORDS * (3 + d), units.torque, torque[d]);
    }
}

void sums_value(const double *sum, bool ordered, struct sums_units units, double force[3], double torque[3]) {
    for (int d = 0; d < 3; d++) {
        force[d] = ordered ? number_value(sum + SUMS_WORDS * d, units.force) : sum[d];
        torque[d] = ordered ? number_value(sum + SUMS_WORDS * (3 + d), units.torque) : sum[3 + d];
    }
}
