/* SPDX-License-Identifier: BSD-3-Clause */
/* Linear systems of lattices: the true residual, computed from the rows, on all preconditioners.
 * Ranks: 1 3 8 */
#include "tests/test.h"

#include "base/memory.h"
#include "lattice_matrix.h"

#include <math.h>

static const char *const preconditioners[] = {"boomeramg", "gamg", "ml", "ilu", "sor", "jacobi", "none"};
enum { PRECONDITIONERS = 7 };

/* Solves with b of random numbers, checks against the rows, and returns the iterations. */
static int try(struct team *team, struct solve *solve, const struct lattice_matrix *lattice,
               const struct solve_options *options) {
    struct error error = {0};
    struct solve_rows rows = lattice_matrix_rows(lattice);
    struct solve_system *system = solve_create(solve, &rows, options, &error);
    double *b = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    double *x = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    int iterations = 0;
    team_expect(team, system != NULL, "%s", error.text);
    if (system != NULL) {
        lattice_matrix_sides(lattice, b, x);
        if (lattice->shift == 0)
            solve_null_space(system, lattice->halves ? 2 : 1, lattice->halves ? lattice->region : NULL);
        bool converged = solve_solve(system, b, x, false);
        const struct solve_report *report = solve_report(system);
        double r = lattice_matrix_residual(lattice, &team->comm, b, x),
               mean = lattice_matrix_mean(lattice, &team->comm, x);
        iterations = report->iterations;
        team_expect(team, converged, "%s, %d^%d: %s after %d iterations", options->preconditioner,
                    lattice->side, lattice->dimension, report->reason, iterations);
        team_expect(team, r <= 10 * options->tolerance, "%s, %d^%d: true residual %g",
                    options->preconditioner, lattice->side, lattice->dimension, r);
        team_expect(team, fabs(report->residual - r) <= 0.1 * r + 1e-8, "residual %g, reported %g", r,
                    report->residual);
        team_expect(team, lattice->shift > 0 || mean < 1e-9, "mean %g", mean);
        team_expect(team, report->solves == 1 && report->set_ups == 1, "one solve with one set-up");
    }
    solve_destroy(&system);
    memory_free(b);
    memory_free(x);
    return iterations;
}

/* All that is checked of a solution is in `try`; a lattice serves all preconditioners. */
static void try_all(struct team *team, struct lattice_matrix lattice, const char *method) {
    struct solve *solve = lattice_matrix_begin(team, NULL);
    if (solve != NULL) {
        lattice_matrix_make(&lattice, &team->comm);
        for (int k = 0; k < PRECONDITIONERS; k++) {
            struct solve_options options = solve_options_singular("test_");
            options.method = method;
            options.preconditioner = preconditioners[k];
            options.tolerance = 1e-6;
            options.iterations = 2000;
            options.restart = 100;
            options.pin = lattice.shift > 0 ? 0 : 1e-9;
            try(team, solve, &lattice, &options);
        }
        lattice_matrix_free(&lattice);
    }
    solve_end(&solve, NULL, 0);
    team_finish(team);
}

static void periodic_poisson(void **state) {
    try_all(*state, (struct lattice_matrix){.dimension = 2, .side = 48}, "fgmres");
    try_all(*state, (struct lattice_matrix){.dimension = 3, .side = 12}, "fgmres");
}

static void perturbed_poisson(void **state) {
    try_all(*state, (struct lattice_matrix){.dimension = 3, .side = 24, .spread = 3}, "fgmres");
    try_all(*state, (struct lattice_matrix){.dimension = 2, .side = 24, .spread = 3}, "gmres");
}

static void two_regions(void **state) {
    try_all(*state, (struct lattice_matrix){.dimension = 2, .side = 24, .halves = true}, "fgmres");
    try_all(*state, (struct lattice_matrix){.dimension = 3, .side = 12, .halves = true, .spread = 1},
            "fgmres");
}

static void helmholtz(void **state) {
    try_all(*state, (struct lattice_matrix){.dimension = 3, .side = 12, .shift = 0.5}, "bicgstab");
    try_all(*state, (struct lattice_matrix){.dimension = 2, .side = 24, .shift = 0.05, .spread = 1}, "cg");
}

/* Sixteen times the rows, or 27, and hardly more iterations. */
static void iterations_are_flat(void **state) {
    struct team *team = *state;
    struct solve *solve = lattice_matrix_begin(team, NULL);
    static const int sides[2][2] = {{48, 192}, {12, 36}};
    for (int d = 0; solve != NULL && d < 2; d++) {
        int iterations[2];
        for (int k = 0; k < 2; k++) {
            struct lattice_matrix lattice = {.dimension = d + 2, .side = sides[d][k], .spread = 0.5};
            struct solve_options options = solve_options_singular("test_");
            options.tolerance = 1e-6;
            lattice_matrix_make(&lattice, &team->comm);
            iterations[k] = try(team, solve, &lattice, &options);
            lattice_matrix_free(&lattice);
        }
        team_expect(team, iterations[0] <= 12 && iterations[1] <= iterations[0] + 3,
                    "iterations %d, then %d, in %d dimensions", iterations[0], iterations[1], d + 2);
    }
    solve_end(&solve, NULL, 0);
    team_finish(team);
}

/* |b - A x - g D| / |b| from the rows, with the diagonal D and the best g. */
static double residual_beside_diagonal(const struct lattice_matrix *lattice, const struct comm *comm,
                                       const double *b, const double *x) {
    double *all = memory_allocate((size_t)lattice->all, sizeof(double), "lattice"), sum[4] = {0};
    comm_gather_all(comm, x, (size_t)lattice->count * sizeof(double), all);
    for (int32_t i = 0; i < lattice->count; i++) {
        double r = b[i], diagonal = 0;
        for (int32_t k = lattice->start[i]; k < lattice->start[i + 1]; k++) {
            r -= lattice->value[k] * all[lattice->column[k]];
            diagonal += lattice->column[k] == lattice->first + i ? lattice->value[k] : 0;
        }
        sum[0] += r * r;
        sum[1] += r * diagonal;
        sum[2] += diagonal * diagonal;
        sum[3] += b[i] * b[i];
    }
    comm_sum(comm, sum, 4);
    memory_free(all);
    return sqrt(fmax(sum[0] - sum[1] * sum[1] / sum[2], 0) / sum[3]);
}

/* Rows that weigh more or less: no x solves A x = b, and the part of b that cannot be reached counts for no residual. */
static void columns_need_not_sum_to_zero(void **state) {
    struct team *team = *state;
    struct error error = {0};
    struct solve *solve = lattice_matrix_begin(team, NULL);
    struct lattice_matrix lattice = {.dimension = 2, .side = 24};
    struct solve_options options = solve_options_singular("test_");
    lattice_matrix_make(&lattice, &team->comm);
    struct solve_rows rows = lattice_matrix_rows(&lattice);
    double *b = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    double *x = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    for (int32_t i = 0; i < rows.count; i++)
        for (int32_t k = lattice.start[i]; k < lattice.start[i + 1]; k++)
            lattice.value[k] *= 1 + lattice_matrix_draw(lattice.first + i, -9);
    struct solve_system *system = solve != NULL ? solve_create(solve, &rows, &options, &error) : NULL;
    team_expect(team, system != NULL, "%s", error.text);
    if (system != NULL) {
        lattice_matrix_sides(&lattice, b, x);
        solve_null_space(system, 1, NULL);
        bool converged = solve_solve(system, b, x, false);
        double r = residual_beside_diagonal(&lattice, &team->comm, b, x),
               whole = lattice_matrix_residual(&lattice, &team->comm, b, x);
        team_expect(team, converged && r < 10 * options.tolerance && whole > 5e-4, "residuals %g, %g", r,
                    whole);
        team_expect(
            team, solve_report(system)->residual < 10 * options.tolerance && !solve_report(system)->doubtful,
            "reported residual %g", solve_report(system)->residual);
        team_expect(team, lattice_matrix_mean(&lattice, &team->comm, x) < 1e-9, "the mean is 0");
    }
    solve_destroy(&system);
    solve_end(&solve, NULL, 0);
    lattice_matrix_free(&lattice);
    memory_free(b);
    memory_free(x);
    team_finish(team);
}

TEAM_MAIN(solve, team_case(periodic_poisson), team_case(perturbed_poisson), team_case(two_regions),
          team_case(helmholtz), team_case(iterations_are_flat), team_case(columns_need_not_sum_to_zero))
