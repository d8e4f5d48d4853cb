/* SPDX-License-Identifier: BSD-3-Clause */
/* Observables of the flow as a whole, and of its solvers. */
#include "physics/fluid/observe_flow.h"
#include "base/memory.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/fluid_state.h"
#include "physics/fluid/lattice/body_surfaces.h"

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

/* Adds the pressure at the part of an open side that belongs to a particle beside it, and the area of that part: two parts a side. */
static void add_side(const struct fluid *fluid, size_t row, const struct weights_foot *foot,
                     const double slope[3], double *part) {
    int side = body_side(foot->body);
    double step = fluid->lattice.step[side / 2], area = fluid->weights.volume[row] / step,
           pressure = fluid->flow.pressure[fluid->weights.first + row];
    if (foot->distance >= step)
        return;
    for (int d = 0; d < fluid->weights.dimension; d++)
        pressure -= foot->distance * foot->normal[d] * slope[d];
    part[2 * side] += area * (foot->pressed ? foot->pressure : pressure);
    part[2 * side + 1] += area;
}

void observe_pressure_drop(const struct observable_context *context, struct observable_item *item,
                           double *part) {
    const struct fluid *fluid = fluid_of(context->view);
    (void)item;
    if (fluid == NULL || fluid->options->opens == 0 || fluid->weights.rows == 0)
        return;
    const struct weights *weights = &fluid->weights;
    double(*slope)[3] = memory_allocate(weights->rows, sizeof *slope, "pressure at open sides");
    operators_gradient(weights, flow_pressure(&fluid->flow), slope);
    for (size_t row = 0; row < weights->rows; row++)
        for (size_t k = weights->foot_start[row]; k < weights->foot_start[row + 1]; k++)
            if (weights->foot[k].open)
                add_side(fluid, row, &weights->foot[k], slope[row], part);
    memory_free(slope);
}

void observe_pressure_drop_finish(const struct output_view *view, const struct observable_item *item,
                                  double *part) {
    const struct fluid *fluid = fluid_of(view);
    (void)item;
    for (int d = 0; d < 3; d++) {
        const double *side = part + 4 * d;
        double drop = side[1] > 0 && side[3] > 0 ? side[0] / side[1] - side[2] / side[3] : 0;
        part[d] = drop + (fluid != NULL ? fluid->drive.force[d] * along(view->box, d) : 0);
    }
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
