/* SPDX-License-Identifier: BSD-3-Clause */
/* Measures what flows through open sides and through the box. Read flow_loss.h first. */
#include "physics/fluid/schemes/flow_loss.h"
#include "physics/fluid/lattice/body_surfaces.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/fluid_state.h"

#include <math.h>

/* Sums over particles: inflow, outflow less inflow, the open area, and what the mean flow has more than the sides say, component by component. */
enum { INFLOW, NET, AREA, EXCESS, SUMS = EXCESS + 3 };

/* A flow slower than this part of the velocity that the driving force gives in a step, or in the time of diffusion over a spacing, is noise of the
 * solver. */
static const double noise = 1e-2;

/* Adds the flow through the part of an open side that belongs to a particle beside it. */
static void add_side(const struct physics_context *context, const struct weights_foot *foot, size_t particle,
                     double volume, double sum[SUMS]) {
    const struct fluid *fluid = context->self;
    const struct particle_state *state = &context->particles->state[particle];
    const double *u = foot->pressed ? state->v : foot->velocity;
    double step = fluid->lattice.step[body_side(foot->body) / 2], out = 0;
    if (foot->distance >= step)
        return;
    for (int d = 0; d < 3; d++)
        out -= u[d] * foot->normal[d] * volume / step;
    sum[INFLOW] += fmax(-out, 0);
    sum[NET] += out;
    sum[AREA] += volume / step;
    for (int d = 0; d < 3; d++)
        sum[EXCESS + d] -=
            out * (state->x[d] - foot->distance * foot->normal[d] - 0.5 * context->box->edge[d]);
}

/* The flow below which a fluid is taken to be at rest. */
static double rest_of(const struct physics_context *context, double area) {
    const struct fluid *fluid = context->self;
    const struct fluid_options *options = context->options;
    const double *f = fluid->drive.force, spacing = options->spacing;
    double time = fmin(grain_dt(context), spacing * spacing * options->density / options->viscosity);
    return noise * area * time * sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]) / options->density;
}

double flow_loss_measure(const struct physics_context *context) {
    const struct fluid *fluid = context->self;
    const struct weights *weights = &fluid->weights;
    const struct box *box = context->box;
    double sum[SUMS] = {0};
    for (size_t row = 0; row < weights->rows; row++) {
        size_t i = weights->first + row;
        for (int d = 0; d < box->dimension; d++)
            sum[EXCESS + d] += weights->volume[row] * context->particles->state[i].v[d];
        for (size_t k = weights->foot_start[row]; k < weights->foot_start[row + 1]; k++)
            if (weights->foot[k].open)
                add_side(context, &weights->foot[k], i, weights->volume[row], sum);
    }
    comm_sum(context->comm, sum, SUMS);
    double most = fabs(sum[NET]);
    for (int d = 0; d < box->dimension; d++)
        if (!box->periodic[d])
            most = fmax(most, fabs(sum[EXCESS + d]) / box->edge[d]);
    return sum[INFLOW] > 0 ? most / (sum[INFLOW] + rest_of(context, sum[AREA])) : 0;
}

void flow_loss_watch(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    double loss = flow_loss_measure(context);
    fluid->leaking = loss > LOSS_MOST ? fluid->leaking + 1 : 0;
    if (fluid->leaking != LOSS_STEPS || fluid->leaked)
        return;
    fluid->leaked = true;
    if (fluid->first)
        log_tell(
            context->log,
            "warning: fluid.open: between the open sides %.2g of the flow gets lost in step %llu, t = %.9g, "
            "and more than %g in each of %d steps up to it; a finer spacing, shorter steps or a box that is "
            "periodic along the flow may help (said once)",
            loss, (unsigned long long)context->clock->step, context->clock->time, LOSS_MOST, LOSS_STEPS);
}
