/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of particles whose motion may be prescribed. */
#include "kernel/particles/groups.h"

#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"

#include <assert.h>

static const struct field group = {.name = "group",
                                   .type = FIELD_UINT8,
                                   .components = 1,
                                   .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_FIXED,
                                   .needed_for = "groups",
                                   .help = "number of the group, 0 = free"};

static const struct field density = {.name = "density",
                                     .type = FIELD_DOUBLE,
                                     .components = 1,
                                     .use = FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED | FIELD_FIXED,
                                     .unit = "kg m-3",
                                     .needed_for = "groups",
                                     .help = "mass / volume"};

void groups_register(struct particles *particles) {
    fields_register(particles, &group);
    fields_register(particles, &density);
}

uint8_t *groups_of(const struct particles *particles) {
    return fields_values(particles, &group);
}

double *groups_densities(const struct particles *particles) {
    return fields_values(particles, &density);
}

double groups_mass(const struct particles *particles, size_t i) {
    const struct particle_state *state = &particles->state[i];
    if (state->inverse_mass > 0)
        return 1 / state->inverse_mass;
    const double *of = groups_densities(particles);
    const uint8_t *kind = kinds_of(particles);
    if (kind && kind[i] != KIND_GRAIN)
        return 0;
    assert(of);
    return particles_sphere_mass(state->radius, of[i]);
}
