/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields with the shape and the orientation that a grain is to get. Read shape.h first. */
#include "kernel/particles/shape.h"

#include "kernel/particles/fields.h"

#include "kernel/particles/kinds.h"

#include <string.h>

static const struct field shape = {
    .name = "source_shape",
    .type = FIELD_INT32,
    .components = 2,
    .needed_for = "bodies",
    .help = "of a new grain alone: number of the shape that its source "
            "names, from 1, 0: none, -1: a sphere; number of its variant, from 1, 0: by the id"};

static const struct field orientation = {
    .name = "orientation",
    .type = FIELD_DOUBLE,
    .components = 4,
    .use = FIELD_TRAVELS | FIELD_OUTPUT,
    .kinds = 1u << KIND_BODY,
    .needed_for = "bodies",
    .help = "unit quaternion w x y z from the principal axes of the body to space"};

void shape_register(struct particles *particles) {
    fields_register(particles, &shape);
    fields_register(particles, &orientation);
}

int32_t (*shape_numbers(const struct particles *particles))[2] {
    return fields_values(particles, &shape);
}

double (*shape_orientations(const struct particles *particles))[4] {
    return fields_values(particles, &orientation);
}

void shape_set(const struct particles *particles, size_t i, int number, int variant, const double turn[4]) {
    int32_t(*numbers)[2] = shape_numbers(particles);
    if (numbers == NULL)
        return;
    numbers[i][0] = number;
    numbers[i][1] = variant;
    memcpy(shape_orientations(particles)[i], turn, 4 * sizeof *turn);
}
