/* SPDX-License-Identifier: BSD-3-Clause */
/* The motion of the particles of a fluid: at rest, with the flow, or as points with a given velocity
 *
 *   w(x, t) = velocity + swing omega cos(omega t) product over d of sin(k_d x_d),   omega = 2 pi / period,
 *
 * k_d = 2 pi / edge in a periodic direction, pi / edge between walls at the faces of the box. */
#ifndef SCREE_SCHEMES_FLUID_MOTION_H
#define SCREE_SCHEMES_FLUID_MOTION_H

#include "engine/physics.h"
#include "physics/fluid/fluid.h"

/* True if the particles move. */
bool fluid_motion_moves(const struct fluid_options *options);

/* As `moving` and `needed` of struct physics and struct physics_pass. */
unsigned fluid_motion_kinds(const void *options);
bool fluid_motion_needed(const struct physics_context *context);

/* True if the keys of the motion go together with the others; else a user's error with the key. */
bool fluid_motion_suits(const struct physics_context *context, struct error *error);

/* The given velocity of a point at x (box-relative). Any thread. */
void fluid_motion_given(const struct fluid_motion *motion, const struct box *box, const double x[3],
                        double time, double w[3]);

/* The pass that moves fluid particles, and boundary particles that ride: as `rows` of struct physics_pass. */
double fluid_motion_move(const struct physics_context *context, int thread, size_t first, size_t last,
                         int size_class);

/* After a step: the drift of the particles, and the advection by it. `speed` is the largest of the fluid. */
void fluid_motion_drift(const struct physics_context *context, double speed);

#endif
