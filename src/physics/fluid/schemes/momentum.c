/* SPDX-License-Identifier: BSD-3-Clause */
/* Solves the implicit part of the momentum equation. Read momentum.h first. */
#include "physics/fluid/schemes/momentum.h"
#include "base/memory.h"
#include "physics/fluid/schemes/residual.h"
#include <math.h>

#include <math.h>

enum { SWEEPS = 3 };

bool momentum_make(struct momentum *momentum, struct solve *solve, struct assembly *assembly,
                   const struct flow *flow, double implicit, const struct solve_options *options,
                   struct error *error) {
    const struct weights *weights = flow->weights;
    *momentum =
        (struct momentum){.systems = weights->slip > 0 ? weights->dimension : 1, .implicit = implicit};
    momentum->side = memory_allocate(weights->rows, sizeof(double), "momentum");
    momentum->guess = memory_allocate(weights->rows, sizeof(double), "momentum");
    for (int s = 0; s < momentum->systems; s++) {
        assembly_momentum(assembly, weights, 1, implicit, s);
        struct solve_rows rows = assembly_rows(assembly);
        momentum->system[s] = solve_create(solve, &rows, options, error);
        if (momentum->system[s] == NULL)
            return false;
    }
    return true;
}

void momentum_free(struct momentum *momentum) {
    for (int s = 0; s < momentum->systems; s++)
        solve_destroy(&momentum->system[s]);
    memory_free(momentum->side);
    memory_free(momentum->guess);
    *momentum = (struct momentum){0};
}

void momentum_refill(struct momentum *momentum) {
    momentum->implicit = NAN;
}

/* The right-hand side of component c: the walls give what the diagonal does not have, taken at the velocity u. */
static void fill_side(const struct momentum *momentum, const struct flow *flow, const double (*side)[3],
                      struct operators_values u, int c) {
    const struct weights *weights = flow->weights;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        const double *own = u.value + (weights->first + row) * u.stride;
        double sum = 0, difference[3];
        size_t e = weights_walls(weights, row);
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
            const struct weights_image *image = weights_image_of(weights, k);
            if (image != NULL) { /* the matrix has its own and the image's part */
                sum += weights_foot_of(weights, k)->pressed
                           ? 0
                           : 2 * weights_scalar(weights, e) * image->velocity[c];
                continue;
            }
            operators_mirror(weights, k, u, own, difference);
            sum +=
                weights_scalar(weights, e) * (difference[c] + assembly_wall_factor(weights, k, c) * own[c]);
        }
        momentum->side[row] = side[row][c] + momentum->implicit * sum;
        momentum->guess[row] = own[c];
    }
}

static void refill(struct momentum *momentum, struct assembly *assembly, const struct flow *flow,
                   double implicit) {
    if (implicit == momentum->implicit)
        return;
    momentum->implicit = implicit;
    for (int s = 0; s < momentum->systems; s++) {
        assembly_momentum(assembly, flow->weights, 1, implicit, s);
        solve_values(momentum->system[s], assembly->value);
        solve_renew(momentum->system[s]); /* a run that is resumed begins with this matrix */
    }
}

bool momentum_solve(struct momentum *momentum, struct assembly *assembly, const struct flow *flow,
                    double implicit, const double (*side)[3], struct error *error) {
    const struct weights *weights = flow->weights;
    bool good = true;
    momentum->residual = 0;
    refill(momentum, assembly, flow, implicit);
    for (int sweep = 0; sweep < (momentum->systems > 1 ? SWEEPS : 1); sweep++)
        for (int c = 0; c < weights->dimension; c++) {
            struct solve_system *system = momentum->system[momentum->systems > 1 ? c : 0];
            fill_side(momentum, flow, side, sweep > 0 ? flow_predicted(flow) : flow_velocity(flow), c);
            solve_solve(system, momentum->side, momentum->guess, true);
            good = residual_check(solve_report(system), "velocity", error) && good;
            momentum->residual = fmax(momentum->residual, solve_report(system)->residual);
            for (size_t row = 0; row < weights->rows; row++)
                flow->predicted[3 * (weights->first + row) + (size_t)c] = momentum->guess[row];
        }
    return good;
}
