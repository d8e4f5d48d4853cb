/* SPDX-License-Identifier: BSD-3-Clause */
/* Describes and registers the fields of bonds: grains that turn, and the number of bonds. */
#include "physics/bonds/bonds_state.h"
#include "kernel/comm/copies.h"
#include "kernel/particles/spin.h"
#include "kernel/particles/kinds.h"

static const struct field number = {
    .name = "bonds",
    .type = FIELD_DOUBLE,
    .components = 1,
    .use = FIELD_OUTPUT,
    .kinds = 1u << KIND_GRAIN,
    .needed_for = "bonds",
    .help = "number of bonds that hold the grain",
};

static const struct field group = {
    .name = "bond_group",
    .type = FIELD_UINT8,
    .components = 1,
    .use = FIELD_GHOST | FIELD_MIGRATE,
    .kinds = 1u << KIND_GRAIN,
    .needed_for = "bonds",
    .help = "the group, for bonds with particles of other ranks",
};

void bonds_fields(struct particles *particles) {
    spin_register(particles);
    copies_register_reach(particles);
    fields_register(particles, &number);
    fields_register(particles, &group);
}

double *bonds_numbers(const struct particles *particles) {
    return fields_values(particles, &number);
}

uint8_t *bonds_groups(const struct particles *particles) {
    return fields_values(particles, &group);
}
