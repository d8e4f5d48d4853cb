/* SPDX-License-Identifier: BSD-3-Clause */
/* A flow on the fields of particles, and the exchange of its arrays. Read flow_fields.h first. */
#include "physics/fluid/schemes/flow_fields.h"
#include "physics/fluid/fluid_fields.h"
#include "kernel/particles/fields.h"

void flow_fields_forward(const struct physics_context *context, enum flow_array array) {
    if (context->ghosts == NULL)
        return;
    struct field_list list = fields_one(fluid_handle(context->particles, array));
    ghosts_forward_begin(context->ghosts, context->particles, &list);
    ghosts_forward_end(context->ghosts, context->particles);
}

void flow_fields_forward_places(const struct physics_context *context) {
    struct field_list list = {.count = 2, .field = {FIELD_POSITION, FIELD_VELOCITY}};
    if (context->ghosts == NULL)
        return;
    ghosts_forward_begin(context->ghosts, context->particles, &list);
    ghosts_forward_end(context->ghosts, context->particles);
}

static void forward(const struct flow *flow, enum flow_array array) {
    flow_fields_forward(flow->context, array);
}

static void *values(const struct physics_context *context, enum flow_array array) {
    return fields_base(context->particles, fluid_handle(context->particles, array), NULL);
}

void flow_fields_take(struct flow *flow, const struct physics_context *context, const struct weights *weights,
                      int regions) {
    *flow = (struct flow){.comm = context->comm,
                          .timers = context->timers,
                          .weights = weights,
                          .velocity = context->particles->state[0].v,
                          .velocity_stride = sizeof *context->particles->state / sizeof(double),
                          .pressure = values(context, FLOW_PRESSURE),
                          .predicted = values(context, FLOW_PREDICTED),
                          .increment = values(context, FLOW_INCREMENT),
                          .advection_before = fluid_advection(context->particles),
                          .velocity_before = fluid_velocity_before(context->particles),
                          .drift = fluid_drift(context->particles),
                          .drift_advection = fluid_drift_advection(context->particles),
                          .gradient = fluid_gradient(context->particles),
                          .row = values(context, FLOW_ROW),
                          .regions = regions,
                          .region = regions > 1 ? fluid_region(context->particles) + weights->first : NULL,
                          .forward = context->ghosts ? forward : NULL,
                          .context = context};
}
