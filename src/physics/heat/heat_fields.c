/* SPDX-License-Identifier: BSD-3-Clause */
/* Describes and registers the fields of heat. */
#include "physics/heat/heat_fields.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
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

static const struct field work = {
    .name = "heat_work",
    .type = FIELD_DOUBLE,
    .components = 2,
    .use = FIELD_REVERSE | FIELD_TRAVELS,
    .kinds = 1u << KIND_GRAIN,
    .unit = "J",
    .needed_for = "heat.dissipation",
    .help = "work that contacts of the grain took in the last step, and energy that their springs hold",
};
static const struct field held = {
    .name = "heat_held",
    .type = FIELD_DOUBLE,
    .components = 1,
    .use = FIELD_TRAVELS,
    .kinds = 1u << KIND_GRAIN,
    .unit = "J",
    .needed_for = "heat.dissipation",
    .help = "energy that springs of contacts of the grain held one step ago",
};

void heat_work_register(struct particles *particles) {
    fields_register(particles, &work);
    fields_register(particles, &held);
}

double *heat_work_field(const struct particles *particles) {
    return fields_values(particles, &work);
}

double *heat_held_field(const struct particles *particles) {
    return fields_values(particles, &held);
}

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
