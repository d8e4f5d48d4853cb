/* SPDX-License-Identifier: BSD-3-Clause */
/* Describes and registers the fields of heat. */
#include "heat/fields.h"
#include "particles/fields.h"
#include "particles/kinds.h"
#include "physics_table.h"
#include <math.h>

static const struct field temperature = {
    .name = "temperature",
    .type = FIELD_DOUBLE,
    .components = 1,
    .use = FIELD_GHOST | FIELD_FORWARD | FIELD_TRAVELS | FIELD_OUTPUT,
    .kinds = 1u << KIND_GRAIN,
    .fill = NAN,
    .unit = "K",
    .needed_for = "heat",
    .help = "temperature",
};
static const struct field flow = {
    .name = "heat_flow",
    .type = FIELD_DOUBLE,
    .components = 1,
    .use = FIELD_REVERSE | FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED,
    .kinds = 1u << KIND_GRAIN,
    .unit = "W",
    .needed_for = "heat",
    .help = "power that flows into the grain",
};
static const struct field wall_flow = {
    .name = "heat_wall_flow",
    .type = FIELD_DOUBLE,
    .components = 1,
    .use = FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED,
    .kinds = 1u << KIND_GRAIN,
    .unit = "W",
    .needed_for = "heat",
    .help = "power that flows from walls into the grain",
};

void heat_fields(struct particles *particles) {
    fields_register(particles, &temperature);
    fields_register(particles, &flow);
    fields_register(particles, &wall_flow);
}

double *heat_temperature(const struct particles *particles) {
    return fields_values(particles, &temperature);
}

double *heat_flow(const struct particles *particles) {
    return fields_values(particles, &flow);
}

double *heat_wall_flow(const struct particles *particles) {
    return fields_values(particles, &wall_flow);
}

bool heat_has(const struct particles *particles, size_t i) {
    const uint8_t *kind = kinds_of(particles);
    return kind == NULL || kind[i] == KIND_GRAIN;
}

int heat_flow_field(const struct particles *particles) {
    return fields_handle(particles, &flow);
}
