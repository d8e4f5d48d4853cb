/* SPDX-License-Identifier: BSD-3-Clause */
/* The step of an incompressible flow: projection_step reads as the scheme. Read projection.h first. */
#include "physics/fluid/schemes/projection_parts.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

/* From this theta dt nu / spacing^2 on Jacobi takes too many iterations. */
#define JACOBI_MOST 20.0

static bool make_systems(struct projection *projection, struct solve *solve, const struct flow *flow,
                         struct error *error) {
    const struct projection_options *options = &projection->options;
    struct solve_options velocity = solve_options_regular("fluid_u_"),
                         pressure = solve_options_singular("fluid_p_");
    double implicit = 0.5 * options->dt * options->viscosity / options->density;
    if (implicit > JACOBI_MOST * options->spacing * options->spacing)
        velocity.preconditioner = options->preconditioner;
    velocity.tolerance = options->tolerance_velocity;
    pressure.preconditioner = options->preconditioner;
    pressure.tolerance = options->tolerance_pressure;
    pressure.reuse = options->reuse;
    return assembly_make(&projection->assembly, flow, error) &&
           momentum_make(&projection->momentum, solve, &projection->assembly, flow, implicit, &velocity,
                         error) &&
           pressure_make(&projection->pressure, solve, &projection->assembly, flow, &pressure, error);
}

struct projection *projection_create(struct solve *solve, const struct flow *flow,
                                     const struct projection_options *options, struct error *error) {
    struct projection *projection = memory_allocate_zero(1, sizeof *projection, "projection");
    size_t rows = flow->weights->rows;
    projection->options = *options;
    projection->pressure.whole = true;
    projection->side = memory_allocate(rows, sizeof *projection->side, "projection");
    projection->viscous = memory_allocate(rows, sizeof *projection->viscous, "projection");
    projection->gradient = memory_allocate(rows, sizeof *projection->gradient, "projection");
    projection->advection = memory_allocate_zero(rows, sizeof *projection->advection, "projection");
    projection->divergence = memory_allocate(rows, sizeof *projection->divergence, "projection");
    projection->source = memory_allocate(rows, sizeof *projection->source, "projection");
    projection->filter = memory_allocate(rows, sizeof *projection->filter, "projection");
    projection->pressed = memory_allocate(rows, sizeof *projection->pressed, "projection");
    if (!make_systems(projection, solve, flow, error))
        projection_destroy(&projection);
    return projection;
}

void projection_destroy(struct projection **projection) {
    struct projection *p = *projection;
    if (p == NULL)
        return;
    momentum_free(&p->momentum);
    pressure_free(&p->pressure);
    assembly_free(&p->assembly);
    memory_free(p->side);
    memory_free(p->viscous);
    memory_free(p->gradient);
    memory_free(p->advection);
    memory_free(p->divergence);
    memory_free(p->source);
    memory_free(p->filter);
    memory_free(p->pressed);
    memory_free(p);
    *projection = NULL;
}

void projection_refill(struct projection *projection, const struct flow *flow) {
    projection_refill_pressure(projection, flow);
    momentum_refill(&projection->momentum);
}

void projection_refill_pressure(struct projection *projection, const struct flow *flow) {
    assembly_pressure(&projection->assembly, flow->weights, true, flow->mobility);
    solve_values(projection->pressure.system, projection->assembly.value);
}

void projection_renew(struct projection *projection) {
    solve_renew(projection->pressure.system);
}

/* The inertia at the middle of the step, extrapolated from this step and the one before; keeps that of this
 * step. */
static void extrapolate_advection(struct projection *projection, const struct flow *flow,
                                  const struct projection_past *past, double dt) {
    const struct weights *weights = flow->weights;
    double ahead = past->steps > 0 ? 0.5 * dt / past->dt : 0;
    if (!projection->options.advection)
        return;
    struct operators_stream stream = {flow_velocity(flow), flow_velocity(flow), 0.5};
    if (flow->carried != NULL)
        stream = (struct operators_stream){
            {.value = flow->carried[0][0], .stride = 6}, {.value = flow->carried[0][1], .stride = 6}, 1};
    operators_inertia(weights, &stream, projection->options.viscosity / projection->options.density,
                      projection->advection);
    for (size_t row = 0; row < weights->rows; row++)
        for (size_t d = 0; d < 3; d++) {
            double *before = &flow->advection_before[3 * (weights->first + row) + d],
                   now = projection->advection[row][d];
            projection->advection[row][d] = now + ahead * (now - *before);
            *before = now;
        }
}

/* u^n + dt [(1 - theta) nu div grad u^n - A - grad p / rho + f / rho]. */
static void fill_side(struct projection *projection, const struct flow *flow, double theta, double dt,
                      const double force[3]) {
    const struct weights *weights = flow->weights;
    double density = projection->options.density, viscous = (1 - theta) * projection->options.viscosity;
    operators_laplacian_velocity(weights, flow_velocity(flow), projection->viscous);
    operators_gradient(weights, flow_pressure(flow), projection->gradient);
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++)
        for (int d = 0; d < 3; d++)
            projection->side[row][d] =
                flow_velocity_of(flow, row)[d] +
                dt * ((viscous * projection->viscous[row][d] - projection->gradient[row][d] +
                       (flow->body != NULL ? force[d] + flow->body[row][d] : force[d])) /
                          density -
                      projection->advection[row][d]);
}

void projection_diverge(struct projection *projection, const struct flow *flow) {
    size_t rows = flow->weights->rows;
    double sum[2] = {0, (double)rows};
    flow_forward(flow, FLOW_PREDICTED);
    operators_divergence(flow->weights, flow_predicted(flow), projection->divergence);
    for (size_t row = 0; row < rows; row++)
        sum[0] += projection->divergence[row] * projection->divergence[row];
    comm_sum(flow->comm, sum, 2);
    projection->divergence_size = sqrt(sum[0] / fmax(sum[1], 1));
}

void projection_keep(struct projection *projection, const struct flow *flow) {
    const struct weights *weights = flow->weights;
    memcpy(projection->pressed, flow->pressure + weights->first, weights->rows * sizeof *projection->pressed);
    for (size_t row = 0; row < weights->rows && flow->velocity_before != NULL; row++)
        memcpy(&flow->velocity_before[3 * (weights->first + row)], flow_velocity_of(flow, row),
               3 * sizeof *flow->velocity_before);
}

void projection_restore(const struct flow *flow) {
    const struct weights *weights = flow->weights;
    for (size_t row = 0; row < weights->rows; row++)
        memcpy(flow_velocity_of(flow, row), &flow->velocity_before[3 * (weights->first + row)],
               3 * sizeof *flow->velocity_before);
}

void projection_correct(struct projection *projection, const struct flow *flow, double rotational,
                        double share) {
    const struct weights *weights = flow->weights;
    flow_forward(flow, FLOW_INCREMENT);
    operators_gradient(weights, flow_increment(flow), projection->gradient);
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        size_t i = weights->first + row;
        double *u = flow_velocity_of(flow, row);
        double part = flow->mobility != NULL ? share * flow->mobility[i] : share;
        for (int d = 0; d < weights->dimension; d++)
            u[d] = flow->predicted[3 * i + (size_t)d] - part * projection->gradient[row][d];
        flow->pressure[i] =
            projection->pressed[row] + flow->increment[i] - rotational * projection->divergence[row];
    }
    flow_forward(flow, FLOW_VELOCITY);
    flow_forward(flow, FLOW_PRESSURE);
}

/* Drag at the end of the step: u* changes less. */
static void resist(const struct flow *flow) {
    const struct weights *weights = flow->weights;
    for (size_t row = 0; row < weights->rows && flow->resist != NULL; row++)
        for (size_t d = 0; d < (size_t)weights->dimension; d++) {
            double *to = &flow->predicted[3 * (weights->first + row) + d],
                   from = flow_velocity_of(flow, row)[d];
            *to = from + (*to - from) / (1 + flow->resist[row]);
        }
}

bool projection_predict(struct projection *projection, const struct flow *flow,
                        const struct projection_past *past, const struct projection_push *push,
                        struct error *error) {
    double theta = projection_theta(past);
    double implicit = theta * push->dt * projection->options.viscosity / projection->options.density;
    extrapolate_advection(projection, flow, past, push->dt);
    fill_side(projection, flow, theta, push->dt, push->force);
    for (size_t row = 0; row < flow->weights->rows && push->impulse != NULL; row++)
        for (int d = 0; d < 3; d++)
            projection->side[row][d] += push->impulse[row][d];
    projection_keep(projection, flow);
    bool good = momentum_solve(&projection->momentum, &projection->assembly, flow, implicit,
                               (const double(*)[3])projection->side, error);
    resist(flow);
    return good;
}

bool projection_project(struct projection *projection, const struct flow *flow, double dt, bool guess,
                        struct error *error) {
    projection_diverge(projection, flow);
    return pressure_solve(&projection->pressure, flow, projection->divergence,
                          projection->options.density / dt, guess, error);
}

bool projection_step(struct projection *projection, const struct flow *flow, struct projection_past *past,
                     double dt, const double force[3], struct error *error) {
    const struct projection_push push = {dt, force, NULL};
    double theta = projection_theta(past);
    if (!projection_predict(projection, flow, past, &push, error) ||
        !projection_project(projection, flow, dt, false, error))
        return false;
    projection_correct(projection, flow, theta * projection->options.viscosity,
                       dt / projection->options.density);
    *past = (struct projection_past){past->steps + 1, dt};
    return true;
}

struct projection_report projection_report(const struct projection *projection) {
    return (struct projection_report){
        .velocity = solve_report(projection->momentum.system[0]),
        .pressure = solve_report(projection->pressure.system),
        .residual = fmax(projection->momentum.residual, solve_report(projection->pressure.system)->residual),
        .divergence = projection->divergence_size};
}
