/* SPDX-License-Identifier: BSD-3-Clause */
/* An applied field around what insulates. Read applied_field.h first. */
#include "physics/fluid/carried/applied_field.h"
#include "base/vector.h"
#include "base/memory.h"
#include "physics/fluid/schemes/pressure.h"
#include <math.h>
#include <string.h>

#define TOLERANCE 1e-9

/* sum[row] = sum of w_ij k_ij E_0 . (x_j - x_i) over what is no wall. */
static void side_make(const struct applied *applied, const double far[3], double *sum) {
    const struct weights *weights = applied->flow->weights;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        size_t walls = weights_walls(weights, row), w = weights->wall_start[row];
        double apart[3];
        sum[row] = 0;
        for (size_t e = weights->start[row]; e < weights->start[row + 1]; e++) {
            if (e >= walls && !weights_foot_of(weights, w++)->open)
                continue;
            weights_apart(weights, applied->input, row, e, apart);
            sum[row] += weights_scalar(weights, e) * applied->share[e] * vector_dot(far, apart);
        }
    }
}

static double determinant(const double a[3], const double b[3], const double c[3]) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* Adds the row of a wall entry to the matrix: - b (x) (the part of x_j - x_i along the wall), by columns. */
static void add_wall(const struct weights *weights, size_t entry, size_t wall, const double apart[3],
                     double column[3][3]) {
    const double *normal = weights_foot_of(weights, wall)->normal, *b = weights_vector(weights, entry);
    double across = vector_dot(apart, normal);
    for (int c = 0; c < weights->dimension; c++)
        for (int d = 0; d < weights->dimension; d++)
            column[c][d] -= b[d] * (apart[c] - across * normal[c]);
}

/* E = - G, (1 - sum over walls of b (x) t) G = sum over the others of b (Phi_j - Phi_i), by Cramer's rule. */
static void gradient_of(const struct applied *applied, size_t row, const double far[3], double *field) {
    const struct weights *weights = applied->flow->weights;
    struct operators_values phi = flow_increment(applied->flow);
    double own = phi.value[weights->first + row], side[3] = {0};
    double column[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    size_t walls = weights_walls(weights, row), w = weights->wall_start[row];
    for (size_t e = weights->start[row]; e < weights->start[row + 1]; e++) {
        const double *b = weights_vector(weights, e);
        double apart[3], step;
        weights_apart(weights, applied->input, row, e, apart);
        if (e >= walls && !weights_foot_of(weights, w)->open) {
            add_wall(weights, e, w++, apart, column);
            continue;
        }
        step = e < walls ? phi.value[pair_partner(weights->partner[e])] - own
                         : operators_pressure_step(weights, w++, phi, own);
        for (int d = 0; d < weights->dimension; d++)
            side[d] += b[d] * (step - vector_dot(far, apart));
    }
    double all = determinant(column[0], column[1], column[2]);
    field[0] = -determinant(side, column[1], column[2]) / all;
    field[1] = -determinant(column[0], side, column[2]) / all;
    field[2] = weights->dimension == 3 ? -determinant(column[0], column[1], side) / all : 0;
}

bool applied_field(const struct applied *applied, const double far[3], double *field, struct error *error) {
    const struct flow *flow = applied->flow;
    const struct weights *weights = flow->weights;
    struct solve_options options = solve_options_singular("fluid_f_");
    struct pressure potential = {.share = applied->share};
    double *sum = memory_allocate(weights->rows, sizeof *sum, "applied field");
    options.tolerance = TOLERANCE;
    options.preconditioner = applied->preconditioner;
    bool good = pressure_make(&potential, applied->solve, applied->assembly, flow, &options, error);
    if (good) {
        side_make(applied, far, sum);
        good = pressure_solve(&potential, flow, sum, 1, false, error);
        flow_forward(flow, FLOW_INCREMENT);
    }
    for (size_t row = 0; good && row < weights->rows; row++)
        gradient_of(applied, row, far, field + 3 * (weights->first + row));
    pressure_free(&potential);
    memory_free(sum);
    return good;
}
