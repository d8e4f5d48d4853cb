/* SPDX-License-Identifier: BSD-3-Clause */
/* The motion of bodies: a step, and their velocities at the full step. bodies.h has the scheme. */
#ifndef SCREE_BODIES_BODIES_MOTION_H
#define SCREE_BODIES_BODIES_MOTION_H

#include "physics/bodies/bodies.h"

/* Moves the bodies by a step: velocities from half a step before to half a step behind the present, then places.
 * Sets the poses, which members take. Collective. */
void bodies_motion_step(struct bodies *bodies, const struct physics_context *context);

/* Velocities at the present, from the forces of the present: of poses, and of the particles of bodies.
 * Collective. */
void bodies_motion_full_step(struct bodies *bodies, const struct physics_context *context);

#endif
