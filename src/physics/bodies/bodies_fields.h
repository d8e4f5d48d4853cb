/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of bodies, beside `body` of their members (physics/grains/motion/carried.h). Values are borrowed until the set
 * grows. */
#ifndef SCREE_BODIES_BODIES_FIELDS_H
#define SCREE_BODIES_BODIES_FIELDS_H

#include "kernel/particles/particles.h"

/* Orientation of each body (rotor.h). */
double (*bodies_orientation(const struct particles *particles))[4];

/* Velocity and angular momentum (in space) at the last half step, and mass of each body. */
double (*bodies_velocity(const struct particles *particles))[3];
double (*bodies_spin(const struct particles *particles))[3];
double *bodies_mass(const struct particles *particles);

/* Of a body: the number of its clump. Of a member: its number in the clump. */
int32_t *bodies_part(const struct particles *particles);

#endif
