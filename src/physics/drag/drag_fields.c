/* SPDX-License-Identifier: BSD-3-Clause */
/* Describes and registers the fields of drag. */
#include "physics/drag/drag_fields.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include "physics_table.h"

static const struct field force = {
    .name = "drag_force",
    .type = FIELD_DOUBLE,
    .components = 3,
    .use = FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED,
    .kinds = 1u << KIND_GRAIN,
    .unit = "N",
    .needed_for = "drag",
    .help = "force of the drag law on the grain",
};
static const struct field porosity = {
    .name = "porosity",
    .type = FIELD_DOUBLE,
    .components = 1,
    .use = FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED,
    .kinds = 1u << KIND_GRAIN,
    .fill = 1.0,
    .needed_for = "a drag law with porosity",
    .help = "share of the fluid in the space around the grain, by the kernel of drag.porosity",
};

void drag_fields(struct particles *particles) {
    fields_register(particles, &force);
}

double *drag_force(const struct particles *particles) {
    return fields_values(particles, &force);
}

void drag_porosity_register(struct particles *particles) {
    fields_register(particles, &porosity);
}

double *drag_porosity(const struct particles *particles) {
    return fields_values(particles, &porosity);
}

int drag_porosity_handle(const struct particles *particles) {
    return fields_handle(particles, &porosity);
}
