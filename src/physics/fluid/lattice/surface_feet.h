/* SPDX-License-Identifier: BSD-3-Clause */
/* Feet on walls and open sides, for mirror.h. */
#ifndef SCREE_LATTICE_SURFACE_FEET_H
#define SCREE_LATTICE_SURFACE_FEET_H

#include "physics/fluid/schemes/open_sides.h"
#include "physics/fluid/fluid_state.h"

/* All borrowed. */
struct feet {
    const struct walls *walls;
    const struct fluid_options *options;
    const struct box *box;
};

/* How far from a wall a place may be of which the foot is asked, length. */
double surface_feet_reach(const struct fluid_options *options, const struct box *box);

/* As `wall` of struct mirror_input; `context` is a struct feet. Any thread. */
void surface_feet_on(const void *context, int64_t body, const double x[3], struct weights_foot *foot);

/* Mirrors of the fluid's weights for the present places and velocities of grains and walls. Returns the number of wall neighbours without a body. */
size_t surface_feet_mirror(const struct physics_context *context, struct fluid *fluid);

#endif
