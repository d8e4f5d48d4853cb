/* SPDX-License-Identifier: BSD-3-Clause */
/* Describes and registers the fields of bodies. */
#include "physics/bodies/bodies_fields.h"
#include "kernel/particles/shape.h"
#include "kernel/particles/spin.h"
#include "physics/grains/motion/carried.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include "physics_table.h"

static const struct field velocity = {.name = "body_velocity",
                                      .type = FIELD_DOUBLE,
                                      .components = 3,
                                      .use = FIELD_TRAVELS | FIELD_FLOWS,
                                      .kinds = 1u << KIND_BODY,
                                      .unit = "m s-1",
                                      .needed_for = "bodies",
                                      .help = "velocity of the body at the last half step"};
static const struct field spin = {.name = "angular_momentum",
                                  .type = FIELD_DOUBLE,
                                  .components = 3,
                                  .use = FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED,
                                  .kinds = 1u << KIND_BODY,
                                  .unit = "kg m2 s-1",
                                  .needed_for = "bodies",
                                  .help =
                                      "angular momentum of the body about its centre at the last half step"};
static const struct field mass = {.name = "body_mass",
                                  .type = FIELD_DOUBLE,
                                  .components = 1,
                                  .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_FIXED,
                                  .kinds = 1u << KIND_BODY,
                                  .unit = "kg",
                                  .needed_for = "bodies",
                                  .help = "mass of the body; that of its members together"};
static const struct field part = {.name = "body_part",
                                  .type = FIELD_INT32,
                                  .components = 1,
                                  .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_FIXED,
                                  .needed_for = "bodies",
                                  .help =
                                      "of a body: number of its clump; of a member: its number in the clump"};

void bodies_fields(struct particles *particles) {
    spin_register(particles);
    carried_register(particles);
    shape_register(particles);
    fields_register(particles, &velocity);
    fields_register(particles, &spin);
    fields_register(particles, &mass);
    fields_register(particles, &part);
}

double (*bodies_orientation(const struct particles *particles))[4] {
    return shape_orientations(particles);
}

double (*bodies_velocity(const struct particles *particles))[3] {
    return fields_values(particles, &velocity);
}

double (*bodies_spin(const struct particles *particles))[3] {
    return fields_values(particles, &spin);
}

double *bodies_mass(const struct particles *particles) {
    return fields_values(particles, &mass);
}

int32_t *bodies_part(const struct particles *particles) {
    return fields_values(particles, &part);
}
