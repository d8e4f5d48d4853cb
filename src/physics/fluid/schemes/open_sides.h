/* SPDX-License-Identifier: BSD-3-Clause */
/* Open sides of the box, through which the fluid comes and goes: each has a given velocity (an inlet, as a rule) or a
 * given pressure (an outlet). Behind an open side lie boundary particles, as behind a wall, whose body is the side
 * (body_surfaces.h); weights.h has the conditions there. */
#ifndef SCREE_SCHEMES_OPEN_SIDES_H
#define SCREE_SCHEMES_OPEN_SIDES_H

#include "engine/physics.h"
#include "physics/fluid/lattice/body_surfaces.h"
#include "physics/fluid/fluid.h"

/* The given condition at a side (2 x direction, 1 more for the upper one); NULL: the side is not open. */
const struct fluid_open *open_at(const struct fluid_options *options, int side);

/* True if a pressure is given at one of the sides. */
bool open_pressed(const struct fluid_options *options);

/* The largest velocity that is given. */
double open_speed(const struct fluid_options *options);

/* The velocity that is given at a place of a side. Any thread. */
void open_velocity(const struct fluid_open *open, const struct box *box, const double x[3],
                   double velocity[3]);

/* The foot of x (box-relative) on a side. Any thread. */
void open_foot(const struct fluid_options *options, const struct box *box, int side, const double x[3],
               struct weights_foot *foot);

/* True if the sides go together, with the box and with the other keys of the fluid; else a user's error with the
 * key. */
bool open_suits(const struct physics_context *context, struct error *error);

/* "x_lower". */
const char *open_name(int side);

#endif
