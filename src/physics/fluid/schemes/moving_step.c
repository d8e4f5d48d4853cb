/* SPDX-License-Identifier: BSD-3-Clause */
/* The step of a flow along the paths of its particles. Read moving_step.h first. */
#include "physics/fluid/schemes/moving_step.h"
#include "base/memory.h"
#include "physics/fluid/schemes/projection_parts.h"

#include <string.h>

/* a u^n - b u^(n-1) + g dt [(1 + r) c^n - r c^(n-1) - grad p / rho + f / rho]. */
static void fill_side(struct projection *projection, const struct flow *flow, double r, double dt,
                      const double force[3]) {
    const struct weights *weights = flow->weights;
    double density = projection->options.density, whole = 1 + 2 * r, g = (1 + r) / whole;
    operators_gradient(weights, flow_pressure(flow), projection->gradient);
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        const double *u = flow_velocity_of(flow, row);
        for (size_t d = 0; d < 3; d++) {
            size_t at = 3 * (weights->first + row) + d;
            double body = flow->body != NULL ? flow->body[row][d] : 0;
            double drift = (1 + r) * flow->drift_advection[at] - r * flow->advection_before[at];
            projection->side[row][d] =
                ((1 + r) * (1 + r) * u[d] - r * r * flow->velocity_before[at]) / whole +
                g * dt * (drift + (force[d] + body - projection->gradient[row][d]) / density);
        }
    }
}

/* projection->filter = tau / rho (div grad p - lap p) away from walls; projection->gradient is grad p. */
static void filter_pressure(struct projection *projection, const struct flow *flow, double share) {
    const struct weights *weights = flow->weights;
    double *sum = (double *)projection->viscous, *laplacian = sum + weights->rows;
    memset(projection->filter, 0, weights->rows * sizeof *projection->filter);
    if (share == 0)
        return;
    memcpy(flow->gradient + 3 * weights->first, projection->gradient,
           weights->rows * sizeof *projection->gradient);
    flow_forward(flow, FLOW_GRADIENT);
    operators_divergence_inner(weights, flow_gradient(flow), sum);
    operators_laplacian(weights, flow_pressure(flow), laplacian);
    for (size_t row = 0; row < weights->rows; row++)
        if (weights->wall_start[row + 1] == weights->wall_start[row])
            projection->filter[row] = share * (sum[row] - laplacian[row]);
}

struct path moving_step_begin(struct projection *projection, const struct flow *flow,
                              const struct projection_past *past, double dt,
                              const struct moving_step_push *push) {
    double r = past->steps > 0 ? dt / past->dt : 0, density = projection->options.density;
    const struct path path = {projection, flow, dt, (1 + r) / (1 + 2 * r)};
    fill_side(projection, flow, r, dt, push->force);
    filter_pressure(projection, flow, push->filter * dt / density);
    projection_keep(projection, flow);
    return path;
}

bool moving_step_try(const struct path *path, struct error *error) {
    struct projection *projection = path->projection;
    double density = projection->options.density, viscosity = projection->options.viscosity;
    double share = path->implicit * path->dt / density;
    projection_restore(path->flow);
    if (!momentum_solve(&projection->momentum, &projection->assembly, path->flow, share * viscosity,
                        (const double(*)[3])projection->side, error))
        return false;
    projection_diverge(projection, path->flow);
    for (size_t row = 0; row < path->flow->weights->rows; row++)
        projection->source[row] = projection->divergence[row] + projection->filter[row];
    if (!pressure_solve(&projection->pressure, path->flow, projection->source, 1 / share, false, error))
        return false;
    projection_correct(projection, path->flow, viscosity, share);
    return true;
}

void moving_step_drift_advect(const struct flow *flow) {
    size_t first = 3 * flow->weights->first, doubles = 3 * flow->weights->rows;
    memcpy(flow->advection_before + first, flow->drift_advection + first,
           doubles * sizeof *flow->drift_advection);
    operators_advection(flow->weights, flow_drift(flow), flow_velocity(flow),
                        (double(*)[3])(flow->drift_advection + first));
}
