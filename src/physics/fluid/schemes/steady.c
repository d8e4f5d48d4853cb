/* SPDX-License-Identifier: BSD-3-Clause */
/* The coupled solver of steady Stokes flow. Read steady.h first.
 *
 * A vector of the solver holds this rank's velocities, component after component, then its pressures. In the
 * solver's units p is p spacing / mu, momentum is multiplied by spacing^2 / mu and continuity by the spacing. */
#include "physics/fluid/schemes/steady.h"
#include "base/memory.h"
#include "physics/fluid/operators/assembly.h"
#include "physics/fluid/schemes/schur.h"

#include <math.h>
#include <string.h>

/* Iterations of a cycle of LGMRES, of which the last ones take corrections of earlier cycles as directions; the solve
 * asks at the end of each cycle whether to go on. */
enum { CYCLE = 16, AUGMENT = 2 };

/* The momentum's residual, as a part of the force, that is small enough. */
#define RESIDUAL_ENOUGH 1e-3

/* A mean flow below so much of the speed is none, and does not judge convergence. */
#define STILL 1e-4

/* The part of a flow between open sides that may get lost on its way. */
#define LOSS_ENOUGH 1e-2

struct steady {
    struct steady_options options;
    const struct flow *flow; /* during a solve */
    struct solve_system *velocity[3], *coupled;
    int systems;
    struct schur schur; /* where a pressure is given */
    size_t rows, unknowns;
    double (*vector)[3],
        *scalar;   /* [rows]: results of operators; in the memory of `product`, of other times */
    double *still; /* [unknowns]: the operator's value of a fluid at rest: walls that move; NULL: 0 */
    double *side, *solution; /* [unknowns] */
    double *product;         /* [4 rows] at least: the operator's value */
    double flow_before[3];   /* mean velocity a cycle ago */
    double speed_before;     /* root mean square of the velocity then */
    double change, residual, loss;
};

/* Spreads a vector of the solver into the arrays of the flow, copies included. */
static void spread(const struct steady *steady, const double *x) {
    const struct flow *flow = steady->flow;
    size_t n = steady->rows, dimension = (size_t)flow->weights->dimension;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < n; row++) {
        size_t i = flow->weights->first + row;
        for (size_t d = 0; d < 3; d++)
            flow->predicted[3 * i + d] = d < dimension ? x[d * n + row] : 0;
        flow->increment[i] = x[dimension * n + row];
    }
    flow_forward(flow, FLOW_PREDICTED);
    flow_forward(flow, FLOW_INCREMENT);
}

/* y = the operator's value, walls that move included. */
static void apply(struct steady *steady, const double *x, double *y) {
    double dx = steady->options.spacing;
    struct operators_values pressure = flow_increment(steady->flow);
    pressure.open = dx / steady->options.viscosity;
    spread(steady, x);
    operators_stokes(steady->flow->weights, flow_predicted(steady->flow), pressure,
                     &(struct operators_stokes){.gradient = dx, .viscous = dx * dx, .divergence = dx}, y);
}

static void multiply(void *context, const double *x, double *y) {
    struct steady *steady = context;
    apply(steady, x, y);
    if (steady->still == NULL)
        return;
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < steady->unknowns; k++)
        y[k] -= steady->still[k];
}

/* Subtracts the mean over each region of the fluid, where the pressure has a free constant. */
static void subtract_means(const struct flow *flow, double *value) {
    size_t n = flow->weights->rows, regions = (size_t)flow->regions;
    if (flow->pressed)
        return;
    double *sum = memory_allocate_zero(2 * regions, sizeof *sum, "means over regions");
    for (size_t row = 0; row < n; row++) {
        size_t region = flow->region != NULL ? (size_t)flow->region[row] : 0;
        sum[region] += value[row];
        sum[regions + region] += 1;
    }
    comm_sum(flow->comm, sum, 2 * flow->regions);
    for (size_t row = 0; row < n; row++) {
        size_t region = flow->region != NULL ? (size_t)flow->region[row] : 0;
        value[row] -= sum[region] / sum[regions + region];
    }
    memory_free(sum);
}

static void precondition(void *context, const double *r, double *z) {
    struct steady *steady = context;
    const struct flow *flow = steady->flow;
    size_t n = steady->rows, dimension = (size_t)flow->weights->dimension;
    double *pressure = z + dimension * n;
    for (size_t row = 0; row < n && !flow->pressed; row++)
        pressure[row] = -r[dimension * n + row];
    if (flow->pressed)
        schur_apply(&steady->schur, flow, r + dimension * n, pressure);
    subtract_means(flow, pressure);
    for (size_t row = 0; row < n; row++)
        flow->increment[flow->weights->first + row] = pressure[row];
    flow_forward(flow, FLOW_INCREMENT);
    operators_gradient(flow->weights, flow_increment(flow), steady->vector);
    for (size_t d = 0; d < dimension; d++) {
        for (size_t row = 0; row < n; row++)
            steady->scalar[row] = r[d * n + row] - steady->options.spacing * steady->vector[row][d];
        solve_cycle(steady->velocity[steady->systems > 1 ? d : 0], steady->scalar, z + d * n);
    }
}

/* The mean velocity over the volume of the fluid, and that volume. */
static void mean_flow(const struct steady *steady, const double *x, double mean[3], double *volume) {
    const struct weights *weights = steady->flow->weights;
    double sum[4] = {0};
    for (size_t row = 0; row < steady->rows; row++) {
        for (int d = 0; d < weights->dimension; d++)
            sum[d] += weights->volume[row] * x[(size_t)d * steady->rows + row];
        sum[3] += weights->volume[row];
    }
    comm_sum(steady->flow->comm, sum, 4);
    for (int d = 0; d < 3; d++)
        mean[d] = sum[d] / sum[3];
    *volume = sum[3];
}

/* What is left of the equations. */
struct rest {
    double momentum;   /* |b - A x| / |b| */
    double divergence; /* root mean square, times the spacing */
    double lost;       /* integral of the divergence: by so much more flows out than in, volume/time */
};

static struct rest rest_of(struct steady *steady, const double *x) {
    const struct weights *weights = steady->flow->weights;
    size_t momentum = (size_t)weights->dimension * steady->rows;
    double sum[5] = {0, 0, 0, 0, (double)steady->rows};
    multiply(steady, x, steady->product);
    for (size_t k = 0; k < steady->unknowns; k++) {
        double gap = steady->side[k] - steady->product[k];
        sum[k < momentum ? 0 : 2] += gap * gap;
        sum[1] += k < momentum ? steady->side[k] * steady->side[k] : 0;
        sum[3] += k < momentum ? 0 : weights->volume[k - momentum] * gap / steady->options.spacing;
    }
    comm_sum(steady->flow->comm, sum, 5);
    return (struct rest){sum[1] > 0 ? sqrt(sum[0] / sum[1]) : 0, sqrt(sum[2] / sum[4]), sum[3]};
}

static double length(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* Root mean square of the velocity. */
static double mean_speed(const struct steady *steady, const double *x) {
    size_t momentum = (size_t)steady->flow->weights->dimension * steady->rows;
    double sum[2] = {0, (double)steady->rows};
    for (size_t k = 0; k < momentum; k++)
        sum[0] += x[k] * x[k];
    comm_sum(steady->flow->comm, sum, 2);
    return sqrt(sum[0] / sum[1]);
}

/* What gets lost between open sides as a part of the flow through a section; 0 without them, where the mean of the
 * continuity is taken out. */
static double loss_of(const struct steady *steady, const struct rest *rest, double speed, double volume) {
    double through = speed * volume / steady->options.edge;
    return steady->flow->pressed && through > 0 ? fabs(rest->lost) / through : 0;
}

static bool enough(void *context, int iteration, const double *x, double residual) {
    struct steady *steady = context;
    double mean[3], difference[3], volume;
    (void)iteration, (void)residual;
    mean_flow(steady, x, mean, &volume);
    for (int d = 0; d < 3; d++) {
        difference[d] = mean[d] - steady->flow_before[d];
        steady->flow_before[d] = mean[d];
    }
    double speed = mean_speed(steady, x), faster = fabs(speed - steady->speed_before);
    steady->speed_before = speed;
    if (length(mean) > STILL * speed)
        steady->change = length(difference) / length(mean);
    else /* rolls without a net flow */
        steady->change = speed > 0 ? faster / speed : 1;
    struct rest rest = rest_of(steady, x);
    steady->residual = rest.momentum;
    steady->loss = loss_of(steady, &rest, length(mean) > STILL * speed ? length(mean) : speed, volume);
    return steady->change <= steady->options.tolerance && steady->residual <= RESIDUAL_ENOUGH &&
           steady->loss <= LOSS_ENOUGH;
}

/* True if walls, grains or given velocities hold the fluid. */
static bool is_held(const struct flow *flow) {
    const struct weights *weights = flow->weights;
    int64_t walls = 0;
    for (size_t k = 0; k < weights->foot_start[weights->rows]; k++)
        walls += !weights->foot[k].pressed;
    comm_sum_int(flow->comm, &walls, 1);
    return walls > 0;
}

static bool make_systems(struct steady *steady, struct solve *solve, const struct flow *flow,
                         struct error *error) {
    struct assembly assembly = {0};
    double dx = steady->options.spacing;
    struct solve_options options = solve_options_regular("fluid_u_");
    options.preconditioner = steady->options.preconditioner;
    options.given_up = true;
    bool good = assembly_make(&assembly, flow, error);
    steady->systems = flow->weights->slip > 0 ? flow->weights->dimension : 1;
    for (int s = 0; good && s < steady->systems; s++) {
        assembly_momentum(&assembly, flow->weights, 0, dx * dx, s);
        struct solve_rows rows = assembly_rows(&assembly);
        steady->velocity[s] = solve_create(solve, &rows, &options, error);
        good = steady->velocity[s] != NULL;
    }
    if (good && flow->pressed)
        good = schur_make(&steady->schur, solve, &assembly, flow, steady->velocity[0], dx * dx,
                          steady->options.preconditioner, error);
    assembly_free(&assembly);
    struct solve_free work = {(int32_t)steady->unknowns, steady, multiply, precondition, enough, CYCLE};
    options = solve_options_regular("fluid_s_");
    options.method = "lgmres";
    options.restart = CYCLE;
    options.augment = AUGMENT;
    options.tolerance = 1e-10;
    options.iterations = steady->options.iterations;
    if (good)
        steady->coupled = solve_create_free(solve, &work, &options, error);
    return good && steady->coupled != NULL;
}

struct steady *steady_create(struct solve *solve, const struct flow *flow,
                             const struct steady_options *options, struct error *error) {
    if (!is_held(flow)) {
        error_set(error, ERROR_USER,
                  "no wall and no grain holds the fluid, so it has no steady flow (fluid.time)");
        return NULL;
    }
    struct steady *steady = memory_allocate_zero(1, sizeof *steady, "steady flow");
    size_t n = flow->weights->rows, unknowns = ((size_t)flow->weights->dimension + 1) * n;
    steady->options = *options;
    steady->flow = flow;
    steady->rows = n;
    steady->unknowns = unknowns;
    steady->side = memory_allocate(unknowns, sizeof(double), "steady flow");
    steady->solution = memory_allocate(unknowns, sizeof(double), "steady flow");
    steady->product = memory_allocate(4 * n, sizeof(double), "steady flow");
    steady->vector = (double(*)[3])(void *)steady->product;
    steady->scalar = steady->product + 3 * n;
    if (!make_systems(steady, solve, flow, error))
        steady_destroy(&steady);
    return steady;
}

void steady_destroy(struct steady **steady) {
    struct steady *s = *steady;
    if (s == NULL)
        return;
    solve_destroy(&s->coupled);
    for (int k = 0; k < s->systems; k++)
        solve_destroy(&s->velocity[k]);
    schur_free(&s->schur);
    memory_free(s->still);
    memory_free(s->side);
    memory_free(s->solution);
    memory_free(s->product);
    memory_free(s);
    *steady = NULL;
}

/* The operator's value of a fluid at rest, kept where it is not 0 on some rank. */
static void make_still(struct steady *steady) {
    int64_t some = 0;
    memory_free(steady->still);
    steady->still = memory_allocate(steady->unknowns, sizeof(double), "steady flow");
    memset(steady->solution, 0, steady->unknowns * sizeof(double));
    apply(steady, steady->solution, steady->still);
    for (size_t k = 0; k < steady->unknowns; k++)
        some |= steady->still[k] != 0;
    comm_max_int(steady->flow->comm, &some, 1);
    if (some)
        return;
    memory_free(steady->still);
    steady->still = NULL;
}

static double still_of(const struct steady *steady, size_t k) {
    return steady->still != NULL ? steady->still[k] : 0;
}

/* Right-hand side and first guess. */
static void fill_side(struct steady *steady, const double force[3]) {
    const struct flow *flow = steady->flow;
    size_t n = steady->rows, dimension = (size_t)flow->weights->dimension;
    double dx = steady->options.spacing, viscosity = steady->options.viscosity;
    make_still(steady);
    for (size_t row = 0; row < n; row++) {
        for (size_t d = 0; d < dimension; d++) {
            double push = flow->body != NULL ? force[d] + flow->body[row][d] : force[d];
            steady->side[d * n + row] = dx * dx / viscosity * push - still_of(steady, d * n + row);
            steady->solution[d * n + row] = flow_velocity_of(flow, row)[d];
        }
        steady->side[dimension * n + row] = -still_of(steady, dimension * n + row);
        steady->solution[dimension * n + row] = flow->pressure[flow->weights->first + row] * dx / viscosity;
    }
    subtract_means(flow, steady->side + dimension * n);
}

/* Puts the solution into the flow. */
static void take(struct steady *steady) {
    const struct flow *flow = steady->flow;
    size_t n = steady->rows, dimension = (size_t)flow->weights->dimension;
    double scale = steady->options.viscosity / steady->options.spacing;
    subtract_means(flow, steady->solution + dimension * n);
    for (size_t row = 0; row < n; row++) {
        for (size_t d = 0; d < dimension; d++)
            flow_velocity_of(flow, row)[d] = steady->solution[d * n + row];
        flow->pressure[flow->weights->first + row] = scale * steady->solution[dimension * n + row];
    }
    flow_forward(flow, FLOW_VELOCITY);
    flow_forward(flow, FLOW_PRESSURE);
}

bool steady_solve(struct steady *steady, const struct flow *flow, const double force[3],
                  struct steady_report *report, struct error *error) {
    double mean[3], volume;
    steady->flow = flow;
    memset(steady->flow_before, 0, sizeof steady->flow_before);
    steady->speed_before = 0;
    for (int s = 0; s < steady->systems; s++)
        solve_prepare(steady->velocity[s]);
    fill_side(steady, force);
    bool converged = solve_solve(steady->coupled, steady->side, steady->solution, true);
    const struct solve_report *coupled = solve_report(steady->coupled),
                              *velocity = solve_report(steady->velocity[0]);
    struct rest rest = rest_of(steady, steady->solution);
    steady->residual = rest.momentum;
    mean_flow(steady, steady->solution, mean, &volume);
    *report = (struct steady_report){.iterations = coupled->iterations,
                                     .converged = converged,
                                     .change = steady->change,
                                     .residual = steady->residual,
                                     .divergence = rest.divergence / fmax(length(mean), 1e-300),
                                     .seconds_set_up = velocity->seconds_set_up,
                                     .seconds_solve = coupled->seconds_solve};
    take(steady);
    if (converged)
        return true;
    return error_set(
        error, ERROR_PHYSICS,
        "the steady flow did not converge in %d iterations (%s): over the last 16 the mean flow "
        "changed by %.2g of itself, the momentum's residual is %.2g of the force, and between open sides "
        "%.2g of "
        "the flow gets lost; %s may help",
        coupled->iterations, coupled->reason, steady->change, steady->residual, steady->loss,
        steady->loss > LOSS_ENOUGH ? "a finer spacing, or a box that is periodic along the flow,"
                                   : "a larger fluid.solver.tolerance or a finer spacing");
}
