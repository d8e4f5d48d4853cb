/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields of scalars. Read scalars_fields.h first. */
#include "physics/fluid/carried/scalars_fields.h"
#include "fields_table.h"
#include "physics/fluid/fluid.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"

#define SCALAR(number)                                                                                       \
    {                                                                                                        \
        .name = "scalar_" number, .type = FIELD_DOUBLE, .components = 1,                                     \
        .use = FIELD_GHOST | FIELD_TRAVELS | FIELD_OUTPUT, .kinds = 1u << KIND_FLUID,                        \
        .needed_for = "fluid.scalars", .help = "scalar " number " that the fluid carries"                    \
    }
#define BEFORE(number)                                                                                       \
    {                                                                                                        \
        .name = "fluid_scalar_before_" number, .type = FIELD_DOUBLE, .components = 1, .use = FIELD_TRAVELS,  \
        .kinds = 1u << KIND_FLUID, .needed_for = "fluid.scalars",                                            \
        .help = "scalar " number " of the step before"                                                       \
    }
static const struct field values[FLUID_SCALARS_MAX] = {SCALAR("1"), SCALAR("2"), SCALAR("3")},
                          befores[FLUID_SCALARS_MAX] = {BEFORE("1"), BEFORE("2"), BEFORE("3")};

void fluid_scalars_register(struct particles *particles) {
    for (int k = 0; k < FLUID_SCALARS_MAX; k++)
        fields_register(particles, &values[k]);
}

void scalars_fields(struct particles *particles, int count) {
    for (int k = 0; k < count; k++) {
        fields_register(particles, &values[k]);
        fields_register(particles, &befores[k]);
    }
}

double *scalars_value(const struct particles *particles, int k) {
    return fields_values(particles, &values[k]);
}

double *scalars_before(const struct particles *particles, int k) {
    return fields_values(particles, &befores[k]);
}

void scalars_fields_forward(const struct physics_context *context, int k) {
    struct field_list list = fields_one(fields_handle(context->particles, &values[k]));
    if (context->ghosts == NULL)
        return;
    ghosts_forward_begin(context->ghosts, context->particles, &list);
    ghosts_forward_end(context->ghosts, context->particles);
}
