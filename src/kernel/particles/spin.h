/* SPDX-License-Identifier: BSD-3-Clause */
/* Spin: particles that turn have an angular velocity and a torque. Registered if the law has a force along
 * the surface (law.spin); without such a force neither field exists. */
#ifndef SCREE_PARTICLES_SPIN_H
#define SCREE_PARTICLES_SPIN_H

#include "kernel/particles/particles.h"

/* Registers `angular_velocity`, and `torque` behind the force of its particle: force_stride becomes 8. */
void spin_register(struct particles *particles);

/* The angular velocities, rad/time, the fourth component 0; NULL if particles do not turn. Borrowed until the
 * set grows. */
double (*spin_of(const struct particles *particles))[4];

/* The same for reading only. */
static inline const double (*spin_values(const struct particles *particles))[4] {
    return (const double(*)[4])spin_of(particles);
}

#endif
