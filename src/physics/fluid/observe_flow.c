/* SPDX-License-Identifier: BSD-3-Clause */
/* Observables of the flow as a whole, and of its solvers. */
#include "physics/fluid/observe_flow.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/fluid_state.h"

#include <math.h>

/* The fluid of a run; NULL before there is one. */
static const struct fluid *fluid_of(const struct output_view *view) {
    return view->own[PHYSICS_fluid];
}

static double along(const struct box *box, int d) {
    return d < box->dimension ? box->edge[d] : 1;
}

/* Numbers that all ranks know are rank 0's part of a sum. */
static bool first_rank(const struct observable_context *context) {
    return context->view->comm->rank == 0 && fluid_of(context->view) != NULL;
}

void observe_flow_rate(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct fluid *fluid = fluid_of(context->view);
    (void)item;
    for (size_t row = 0; fluid != NULL && row < fluid->weights.rows; row++)
        for (int d = 0; d < context->view->box->dimension; d++)
            part[d] += fluid->options->density * fluid->weights.volume[row] *
                       rigid_fields_free(context->view->particles, fluid->weights.first + row) *
                       context->view->particles->state[fluid->weights.first + row].v[d] /
                       along(context->view->box, d);
}

void observe_pressure_drop(const struct observable_context *context, struct observable_item *item,
                           double *part) {
    (void)item;
    for (int d = 0; first_rank(context) && d < 3; d++)
        part[d] = fluid_of(context->view)->drive.force[d] * along(context->view->box, d);
}

/* The parts: the superficial velocity along the force, times the viscosity; the force. */
void observe_permeability(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    const struct fluid *fluid = fluid_of(context->view);
    const struct box *box = context->view->box;
    double volume = along(box, 0) * along(box, 1) * along(box, 2), size = 0;
    (void)item;
    if (fluid == NULL)
        return;
    const double *force = fluid->drive.force;
    size = sqrt(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
    for (size_t row = 0; size > 0 && row < fluid->weights.rows; row++)
        for (int d = 0; d < 3; d++)
            part[0] += fluid->options->viscosity * fluid->weights.volume[row] * force[d] / size *
                       rigid_fields_free(context->view->particles, fluid->weights.first + row) *
                       context->view->particles->state[fluid->weights.first + row].v[d] / volume;
    part[1] = first_rank(context) ? size : 0;
}

void observe_permeability_finish(const struct output_view *view, const struct observable_item *item,
                                 double *part) {
    (void)view, (void)item;
    part[0] = part[1] > 0 ? part[0] / part[1] : NAN;
}

void observe_iterations(const struct observable_context *context, struct observable_item *item,
                        double *part) {
    const struct fluid *fluid = fluid_of(context->view);
    (void)item;
    if (!first_rank(context))
        return;
    part[0] = fluid->report.iterations;
    if (fluid->projection != NULL)
        part[0] = projection_report(fluid->projection).pressure->iterations;
}

void observe_residual(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct fluid *fluid = fluid_of(context->view);
    (void)item;
    if (!first_rank(context))
        return;
    part[0] = fluid->report.residual;
    if (fluid->projection != NULL)
        part[0] = projection_report(fluid->projection).residual;
}
