/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of rigid grains. Read rigid_fields.h first. */
#include "physics/fluid/coupling/rigid_fields.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include <math.h>

/* clang-format off */
#define OF_RIGID .kinds = 1u << KIND_GRAIN | 1u << KIND_BODY
static const struct field
    solid = {.name = "solid", .type = FIELD_DOUBLE, .components = 1, .use = FIELD_OUTPUT | FIELD_ASKED, .kinds = 1u << KIND_FLUID, .needed_for = "fluid.grains",
             .help = "part of a fluid particle that grains fill, 0 ... 1, where the flow is rigid inside of grains"},
    forcing = {.name = "fluid_forcing", .type = FIELD_DOUBLE, .components = 3, .use = FIELD_TRAVELS, .unit = "m s-1", .kinds = 1u << KIND_FLUID, .needed_for = "fluid.grains",
               .help = "change of the velocity by which the last step made grains rigid bodies"},
    potential = {.name = "fluid_potential", .type = FIELD_DOUBLE, .components = 1, .use = FIELD_TRAVELS, .unit = "Pa", .kinds = 1u << KIND_FLUID, .needed_for = "fluid.grains",
                 .help = "change of the pressure in the last step"},
    motion_of = {.name = "fluid_motion", .type = FIELD_DOUBLE, .components = 12, .use = FIELD_TRAVELS, .fill = NAN,
                 OF_RIGID, .needed_for = "fluid.grains",
                 .help = "velocity (m/s) and spin (rad/s) of a grain after the last step of the fluid, and their changes in it"},
    impulse = {.name = "fluid_impulse", .type = FIELD_DOUBLE, .components = 6, .use = FIELD_TRAVELS, OF_RIGID,
               .needed_for = "fluid.grains",
               .help = "momentum (N s, N m s) that contacts gave a grain since the last step of the fluid"},
    held = {.name = "fluid_held", .type = FIELD_DOUBLE, .components = 6, .use = FIELD_TRAVELS, .fill = NAN,
            OF_RIGID, .needed_for = "fluid.grains",
            .help = "force (N) and torque (N m) of the fluid that a grain has in its own steps"},
    found = {.name = "fluid_found", .type = FIELD_DOUBLE, .components = 6, OF_RIGID,
             .needed_for = "fluid.grains", .help = "velocity and spin of a grain within a step"};
/* clang-format on */

void rigid_fields_add(struct particles *particles) {
    fields_register(particles, &solid);
    fields_register(particles, &forcing);
    fields_register(particles, &potential);
    fields_register(particles, &motion_of);
    fields_register(particles, &impulse);
    fields_register(particles, &held);
    fields_register(particles, &found);
}

double *rigid_fields_solid(const struct particles *particles) {
    return fields_values(particles, &solid);
}

void rigid_fields_solid_forward(const struct physics_context *context) {
    struct field_list list = fields_one(fields_handle(context->particles, &solid));
    if (context->ghosts == NULL)
        return;
    ghosts_forward_begin(context->ghosts, context->particles, &list);
    ghosts_forward_end(context->ghosts, context->particles);
}

double (*rigid_fields_forcing(const struct particles *particles))[3] {
    return fields_values(particles, &forcing);
}

double *rigid_fields_potential(const struct particles *particles) {
    return fields_values(particles, &potential);
}

double (*rigid_fields_motion(const struct particles *particles))[12] {
    return fields_values(particles, &motion_of);
}

double (*rigid_fields_impulse(const struct particles *particles))[6] {
    return fields_values(particles, &impulse);
}

double (*rigid_fields_held(const struct particles *particles))[6] {
    return fields_values(particles, &held);
}

double (*rigid_fields_found(const struct particles *particles))[6] {
    return fields_values(particles, &found);
}

int rigid_fields_found_handle(const struct particles *particles) {
    return fields_handle(particles, &found);
}

double rigid_fields_free(const struct particles *particles, size_t i) {
    const double *filled = rigid_fields_solid(particles);
    return filled != NULL ? 1 - filled[i] : 1;
}
