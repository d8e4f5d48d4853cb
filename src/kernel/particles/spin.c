/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of particles that turn. */
#include "kernel/particles/spin.h"

#include "kernel/particles/fields.h"

static const struct field angular_velocity = {.name = "angular_velocity",
                                              .type = FIELD_DOUBLE,
                                              .components = 3,
                                              .room = 4,
                                              .use =
                                                  FIELD_GHOST | FIELD_FORWARD | FIELD_TRAVELS | FIELD_OUTPUT,
                                              .unit = "rad s-1",
                                              .needed_for = "friction or rolling resistance",
                                              .help = "angular velocity"};

static const struct field torque = {.name = "torque",
                                    .type = FIELD_DOUBLE,
                                    .components = 3,
                                    .room = 4,
                                    .use = FIELD_REVERSE | FIELD_TRAVELS | FIELD_OUTPUT,
                                    .unit = "N m",
                                    .needed_for = "friction or rolling resistance",
                                    .help = "torque about the centre"};

void spin_register(struct particles *particles) {
    fields_register(particles, &angular_velocity);
    fields_register_with_force(particles, &torque);
}

double (*spin_of(const struct particles *particles))[4] {
    return fields_values(particles, &angular_velocity);
}
