/* SPDX-License-Identifier: BSD-3-Clause */
/* The field with the shape that a grain is to become. Read shape.h first. */
#include "kernel/particles/shape.h"

#include "kernel/particles/fields.h"

static const struct field shape = {.name = "source_shape",
                                   .type = FIELD_INT32,
                                   .components = 1,
                                   .needed_for = "bodies",
                                   .help = "of a new grain alone: number of the shape that its source "
                                           "names, from 1; 0: none"};

void shape_register(struct particles *particles) {
    fields_register(particles, &shape);
}

int32_t *shape_numbers(const struct particles *particles) {
    return fields_values(particles, &shape);
}
