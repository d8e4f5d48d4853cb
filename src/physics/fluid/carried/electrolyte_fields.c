/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of an electrolyte. Read electrolyte_fields.h first. */
#include "physics/fluid/carried/electrolyte_fields.h"
#include "fields_table.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"

#define OF_IONS .kinds = 1u << KIND_FLUID, .needed_for = "fluid.electrolyte"
static const struct field potential = {.name = "potential",
                                       .type = FIELD_DOUBLE,
                                       .components = 1,
                                       .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT,
                                       .unit = "V",
                                       OF_IONS,
                                       .help = "potential of the ions and the charged surfaces"};
static const struct field charge = {.name = "charge_density",
                                    .type = FIELD_DOUBLE,
                                    .components = 1,
                                    .use = FIELD_TRAVELS | FIELD_OUTPUT,
                                    .unit = "C m-3",
                                    OF_IONS,
                                    .help = "charge of the ions over volume"};
static const struct field applied = {.name = "electric_field",
                                     .type = FIELD_DOUBLE,
                                     .components = 3,
                                     .use = FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED,
                                     .unit = "V m-1",
                                     OF_IONS,
                                     .help = "applied field, around what insulates"};

void fluid_electrolyte_register(struct particles *particles) {
    electrolyte_fields(particles);
}

void electrolyte_fields(struct particles *particles) {
    fields_register(particles, &potential);
    fields_register(particles, &charge);
    fields_register(particles, &applied);
}

double *electrolyte_potential(const struct particles *particles) {
    return fields_values(particles, &potential);
}

double *electrolyte_charge(const struct particles *particles) {
    return fields_values(particles, &charge);
}

double *electrolyte_field(const struct particles *particles) {
    return fields_values(particles, &applied);
}

void electrolyte_fields_forward(const struct physics_context *context) {
    struct field_list list = fields_one(fields_handle(context->particles, &potential));
    if (context->ghosts == NULL)
        return;
    ghosts_forward_begin(context->ghosts, context->particles, &list);
    ghosts_forward_end(context->ghosts, context->particles);
}
