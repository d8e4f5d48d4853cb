/* SPDX-License-Identifier: BSD-3-Clause */
/* Multigrid for Darcy's part of a Stokes flow. Read schur.h first. */
#include "physics/fluid/schemes/schur.h"
#include "base/memory.h"
#include <math.h>

/* The residual that k may have, and its least value as a part of the largest one. */
#define K_TOLERANCE 1e-2
#define K_LEAST 1e-6

/* Puts k into the flow's increment, copies included. */
static void fill_k(const struct schur *schur, const struct flow *flow, struct solve_system *velocity,
                   double scale) {
    size_t rows = flow->weights->rows;
    double *side = memory_allocate(rows, sizeof *side, "steady flow"), most = 0;
    for (size_t row = 0; row < rows; row++)
        side[row] = scale;
    solve_tolerance(velocity, K_TOLERANCE);
    solve_solve(velocity, side, schur->value, false);
    memory_free(side);
    for (size_t row = 0; row < rows; row++)
        most = fmax(most, schur->value[row]);
    comm_max(flow->comm, &most, 1);
    for (size_t row = 0; row < rows; row++)
        flow->increment[flow->weights->first + row] = fmax(schur->value[row], K_LEAST * most);
    flow_forward(flow, FLOW_INCREMENT);
}

bool schur_make(struct schur *schur, struct solve *solve, struct assembly *assembly, const struct flow *flow,
                struct solve_system *velocity, double scale, const char *preconditioner,
                struct error *error) {
    struct solve_options options = solve_options_regular("fluid_p_");
    options.preconditioner = preconditioner;
    options.given_up = true;
    schur->value = memory_allocate(flow->weights->rows, sizeof(double), "steady flow");
    fill_k(schur, flow, velocity, scale);
    assembly_darcy(assembly, flow->weights, flow_increment(flow));
    struct solve_rows rows = assembly_rows(assembly);
    schur->system = solve_create(solve, &rows, &options, error);
    if (schur->system != NULL)
        solve_prepare(schur->system);
    return schur->system != NULL;
}

void schur_free(struct schur *schur) {
    solve_destroy(&schur->system);
    memory_free(schur->value);
    *schur = (struct schur){0};
}

void schur_apply(struct schur *schur, const struct flow *flow, const double *r, double *z) {
    solve_cycle(schur->system, r, schur->value);
    for (size_t row = 0; row < flow->weights->rows; row++)
        z[row] = -(r[row] + schur->value[row]);
}
