/* SPDX-License-Identifier: BSD-3-Clause */
/* Fluxes between neighbours without sources. Read neighbour_fluxes.h first. */
#include "physics/fluid/operators/neighbour_fluxes.h"
#include "base/memory.h"

/* Of the equation of phi: what is left of it is a source of a scalar. */
#define TOLERANCE 1e-8

static double along(const struct weights *weights, size_t entry, const double *a, const double *b) {
    size_t dimension = (size_t)weights->dimension;
    double sum = 0;
    for (size_t d = 0; d < dimension; d++)
        sum += weights_vector(weights, entry)[d] * (a[d] + b[d]);
    return sum;
}

/* carry = b_ij . (u_i + u_j), and its sums; on displaced particles u_i . b_ij. */
static void carry_raw(struct fluxes *fluxes, const struct flow *flow, bool lattice) {
    const struct weights *weights = flow->weights;
    const double none[3] = {0};
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        const double *own = flow_velocity_of(flow, row);
        double sum = 0, difference[3], other[3], from[3], to[3];
        weights_whole(weights, weights->first + row, own, from);
        size_t e = weights->start[row];
        for (; e < weights_walls(weights, row); e++) {
            size_t j = pair_partner(weights->partner[e]);
            weights_whole(weights, j, flow->velocity + j * flow->velocity_stride, to);
            fluxes->carry[e] = along(weights, e, from, lattice ? to : none);
            sum += fluxes->carry[e];
        }
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
            fluxes->carry[e] = 0;
            if (!weights_foot_of(weights, k)->open)
                continue;
            operators_mirror(weights, k, flow_velocity(flow), own, difference);
            for (int d = 0; d < 3; d++)
                other[d] = own[d] + difference[d];
            const struct weights_image *image = weights_image_of(weights, k);
            weights_whole(weights, image != NULL ? image->particle : weights->first + row, other, to);
            fluxes->carry[e] = along(weights, e, from, lattice ? to : none);
            sum += fluxes->carry[e];
        }
        fluxes->sum[row] = sum;
    }
}

/* carry = (carry - w_ij (phi_j - phi_i)) / 2. */
static void carry_balance(struct fluxes *fluxes, const struct flow *flow) {
    const struct weights *weights = flow->weights;
    struct operators_values phi = flow_increment(flow);
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        double own = phi.value[weights->first + row];
        size_t e = weights->start[row];
        for (; e < weights_walls(weights, row); e++)
            fluxes->carry[e] =
                0.5 * (fluxes->carry[e] -
                       weights_scalar(weights, e) * (phi.value[pair_partner(weights->partner[e])] - own));
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++)
            if (weights_foot_of(weights, k)->open)
                fluxes->carry[e] =
                    0.5 * (fluxes->carry[e] -
                           weights_scalar(weights, e) * operators_pressure_step(weights, k, phi, own));
    }
}

static bool balance(struct fluxes *fluxes, struct solve *solve, struct assembly *assembly,
                    const struct flow *flow, struct error *error) {
    struct solve_options options = solve_options_singular("fluid_f_");
    options.tolerance = TOLERANCE;
    if (fluxes->pressure.system == NULL &&
        !pressure_make(&fluxes->pressure, solve, assembly, flow, &options, error))
        return false;
    if (!pressure_solve(&fluxes->pressure, flow, fluxes->sum, 1, false, error))
        return false;
    flow_forward(flow, FLOW_INCREMENT);
    carry_balance(fluxes, flow);
    return true;
}

bool neighbour_fluxes_make(struct fluxes *fluxes, struct solve *solve, struct assembly *assembly,
                           const struct flow *flow, bool lattice, struct error *error) {
    const struct weights *weights = flow->weights;
    if (fluxes->carry == NULL) {
        fluxes->carry =
            memory_allocate(weights->start[weights->rows], sizeof *fluxes->carry, "fluxes of scalars");
        fluxes->sum = memory_allocate(weights->rows, sizeof *fluxes->sum, "fluxes of scalars");
    }
    carry_raw(fluxes, flow, lattice);
    return !lattice || balance(fluxes, solve, assembly, flow, error);
}

void neighbour_fluxes_free(struct fluxes *fluxes) {
    pressure_free(&fluxes->pressure);
    memory_free(fluxes->carry);
    memory_free(fluxes->sum);
    *fluxes = (struct fluxes){0};
}
