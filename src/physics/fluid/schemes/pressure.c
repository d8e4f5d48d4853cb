/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes and solves the Poisson equation of the pressure. Read pressure.h first. */
#include "physics/fluid/schemes/pressure.h"
#include "base/memory.h"
#include "physics/fluid/schemes/residual.h"

bool pressure_make(struct pressure *pressure, struct solve *solve, struct assembly *assembly,
                   const struct flow *flow, const struct solve_options *options, struct error *error) {
    const struct weights *weights = flow->weights;
    struct solve_options own = *options;
    own.pin = flow->pressed ? 0 : own.pin;
    if (pressure->share != NULL)
        assembly_shared(assembly, weights, pressure->share);
    else
        assembly_pressure(assembly, weights, pressure->whole, pressure->whole ? flow->mobility : NULL);
    struct solve_rows rows = assembly_rows(assembly);
    pressure->side = memory_allocate(weights->rows, sizeof(double), "pressure");
    pressure->solution = memory_allocate_zero(weights->rows, sizeof(double), "pressure");
    pressure->system = solve_create(solve, &rows, &own, error);
    if (pressure->system == NULL)
        return false;
    if (flow->regions > SOLVE_REGIONS_MAX)
        return error_set(error, ERROR_USER,
                         "the fluid is in %d regions that are not connected; at most %d are allowed",
                         flow->regions, SOLVE_REGIONS_MAX);
    if (!flow->pressed)
        solve_null_space(pressure->system, flow->regions, flow->region);
    return true;
}

void pressure_free(struct pressure *pressure) {
    solve_destroy(&pressure->system);
    memory_free(pressure->side);
    memory_free(pressure->solution);
    *pressure = (struct pressure){.whole = pressure->whole};
}

bool pressure_solve(struct pressure *pressure, const struct flow *flow, const double *divergence,
                    double factor, bool guess, struct error *error) {
    const struct weights *weights = flow->weights;
    for (size_t row = 0; row < weights->rows; row++)
        pressure->side[row] = -factor * divergence[row];
    for (size_t row = 0; guess && row < weights->rows; row++)
        pressure->solution[row] = flow->increment[weights->first + row];
    solve_solve(pressure->system, pressure->side, pressure->solution, guess);
    for (size_t row = 0; row < weights->rows; row++)
        flow->increment[weights->first + row] = pressure->solution[row];
    return residual_check(solve_report(pressure->system), "pressure", error);
}
