/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums of forces and torques of members over ranks. In reproducible runs a number is cut into four whole numbers of
 * 32 bits, in units that depend on the body alone; sums of whole numbers are exact in any order, and what is left
 * behind the last of them is below 2^-108 of the force that moves the body by its radius in a step. */
#ifndef SCREE_BODIES_SUMS_H
#define SCREE_BODIES_SUMS_H

#include <stdbool.h>

enum { SUMS_WORDS = 4, SUMS_PLAIN = 6, SUMS_ORDERED = 6 * SUMS_WORDS };

/* Units of the forces and torques on a body: powers of two. */
struct sums_units {
    int force, torque;
};
struct sums_units sums_units_of(double mass, double radius, double dt);

/* Doubles of a sum. */
static inline int sums_width(bool ordered) {
    return ordered ? SUMS_ORDERED : SUMS_PLAIN;
}

/* Adds a force and a torque to a sum, which begins as zero. */
void sums_add(double *sum, bool ordered, struct sums_units units, const double force[3],
              const double torque[3]);

/* The force and the torque of a sum. */
void sums_value(const double *sum, bool ordered, struct sums_units units, double force[3], double torque[3]);

#endif
