/* SPDX-License-Identifier: BSD-3-Clause */
/* Feet on walls and open sides. Read surface_feet.h first. */
#include "physics/fluid/lattice/surface_feet.h"
#include "physics/grains/grains.h"
#include "kernel/particles/spin.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/lattice/mirror.h"
#include <math.h>
#include <string.h>

double surface_feet_reach(const struct fluid_options *options, const struct box *box) {
    return fluid_support(options, box->dimension) + 2 * options->spacing;
}

void surface_feet_on(const void *context, int64_t body, const double x[3], struct weights_foot *foot) {
    const struct feet *feet = context;
    struct wall_foot found;
    int side = body_side(body);
    if (side >= 0) {
        open_foot(feet->options, feet->box, side, x, foot);
        return;
    }
    walls_foot(feet->walls, body_wall(body), x, surface_feet_reach(feet->options, feet->box), &found);
    foot->distance = found.distance;
    memcpy(foot->normal, found.normal, sizeof foot->normal);
    memcpy(foot->spin, found.spin, sizeof foot->spin);
    const double *w = found.spin, *n = found.normal;
    for (int d = 0; d < 3; d++)
        foot->velocity[d] =
            found.velocity[d] + (isfinite(found.distance) ? found.distance : 0) *
                                    (w[(d + 1) % 3] * n[(d + 2) % 3] - w[(d + 2) % 3] * n[(d + 1) % 3]);
}

size_t surface_feet_mirror(const struct physics_context *context, struct fluid *fluid) {
    const struct feet feet = {grains_walls(context), fluid->options, context->box};
    const struct mirror_input mirror = {.rows = &fluid->input,
                                        .body = fluid_body(context->particles),
                                        .spin = (const double(*)[4])spin_of(context->particles),
                                        .spacing = fluid->options->spacing,
                                        .support = fluid->support,
                                        .wall = surface_feet_on,
                                        .context = &feet};
    return mirror_make(&fluid->weights, &mirror);
}
