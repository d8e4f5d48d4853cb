/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of a fluid, and its observables. Read fields.h first. */
#include "fluid/fields.h"
#include "observe/observables_kinds.h"
#include "particles/fields.h"
#include "particles/kinds.h"
#include "physics_table.h"

/* clang-format off */
#define OF_FLUID .kinds = 1u << KIND_FLUID, .needed_for = "fluid"
static const struct field
    pressure = {.name = "pressure", .type = FIELD_DOUBLE, .components = 1, .use = FIELD_TRAVELS | FIELD_OUTPUT,
                .unit = "Pa", OF_FLUID, .help = "pressure of the fluid, of mean 0 and without what drives the flow"},
    region = {.name = "fluid_region", .type = FIELD_INT32, .components = 1,
              .use = FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED | FIELD_FIXED, OF_FLUID,
              .help = "number of the connected region of fluid, from the largest one, 0, on"},
    body = {.name = "body", .type = FIELD_INT64, .components = 1,
            .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED | FIELD_FIXED,
            .kinds = 1u << KIND_BOUNDARY, .needed_for = "fluid",
            .help = "of a boundary particle: id of its grain, or -1 - number of its wall; 0: a closed pocket"};
/* clang-format on */

void fluid_fields(struct particles *particles) {
    fields_register(particles, &pressure);
    fields_register(particles, &region);
    fields_register(particles, &body);
}

double *fluid_pressure(const struct particles *particles) {
    return fields_values(particles, &pressure);
}

int32_t *fluid_region(const struct particles *particles) {
    return fields_values(particles, &region);
}

int64_t *fluid_body(const struct particles *particles) {
    return fields_values(particles, &body);
}

const struct observable_table fluid_observables = {NULL, 0};
