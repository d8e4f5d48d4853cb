/* SPDX-License-Identifier: BSD-3-Clause */
/* The field with the material of each particle. */
#include "kernel/particles/material.h"

#include "kernel/particles/fields.h"

static const struct field material = {.name = "material",
                                      .type = FIELD_UINT8,
                                      .components = 1,
                                      .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_FIXED,
                                      .needed_for = "more than one material",
                                      .help = "number of the material, from 0"};

void material_register(struct particles *particles) {
    fields_register(particles, &material);
}

uint8_t *material_numbers(const struct particles *particles) {
    return fields_values(particles, &material);
}
