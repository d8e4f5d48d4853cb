/* SPDX-License-Identifier: BSD-3-Clause */
/* Promises of the interface to the linear solvers: new values, preconditioners that are kept, options, operators without a
 * matrix.
 * Ranks: 1 2 4 */
#include "tests/test.h"

#include "base/memory.h"
#include "lattice_matrix.h"

#include <math.h>
#include <string.h>

/* What is told of all systems of a prefix is that of the only one. */
static void totals_expect(struct team *team, const struct solve *solve, const struct solve_system *system) {
    const struct solve_report *one = solve_report(system), *all = solve_total(solve, "test_");
    team_expect(team,
                all->solves == one->solves && all->set_ups == one->set_ups && all->kept == one->kept &&
                    all->iterations_all == one->iterations_all && all->residual == one->residual &&
                    all->residual_worst == one->residual_worst && all->rows == one->rows &&
                    all->entries == one->entries,
                "%d solves, %d in all", (int)one->solves, (int)all->solves);
    team_expect(team, all->rows == 48 * 48 && all->entries == 5 * 48 * 48 && all->products == 6, "%d rows",
                (int)all->rows);
}

/* New values, twice the old: half the solution; the old preconditioner serves as often as allowed. */
static void values_are_refilled(void **state) {
    struct team *team = *state;
    struct error error = {0};
    struct solve *solve = lattice_matrix_begin(team, NULL);
    struct lattice_matrix lattice = {.dimension = 2, .side = 48};
    struct solve_options options = solve_options_singular("test_");
    options.reuse = 2;
    options.tolerance = 1e-8;
    lattice_matrix_make(&lattice, &team->comm);
    struct solve_rows rows = lattice_matrix_rows(&lattice);
    struct solve_system *system = solve != NULL ? solve_create(solve, &rows, &options, &error) : NULL;
    double *b = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    double *x = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    double *before = memory_allocate_zero((size_t)rows.count, sizeof(double), "lattice");
    team_expect(team, system != NULL, "%s", error.text);
    if (system != NULL)
        solve_null_space(system, 1, NULL);
    for (int turn = 0; system != NULL && turn < 5; turn++) {
        lattice_matrix_sides(&lattice, b, x);
        solve_solve(system, b, x, false);
        double r = lattice_matrix_residual(&lattice, &team->comm, b, x), difference = 0;
        team_expect(team, r < 1e-7, "true residual %g in turn %d", r, turn);
        for (int32_t i = 0; i < rows.count; i++)
            difference = fmax(difference, turn > 0 ? fabs(2 * x[i] - before[i]) : 0);
        team_expect(team, difference < 1e-4, "half the solution, but for %g, in turn %d", difference, turn);
        memcpy(before, x, (size_t)rows.count * sizeof *x);
        for (int32_t k = 0; k < rows.start[rows.count]; k++)
            lattice.value[k] *= 2;
        solve_values(system, lattice.value);
        const struct solve_report *report = solve_report(system);
        team_expect(team, report->set_ups == 1 + turn / 3 && report->kept == turn - turn / 3,
                    "%d set-ups, %d kept after turn %d", (int)report->set_ups, (int)report->kept, turn);
    }
    if (system != NULL) { /* the next turn would keep the preconditioner */
        solve_renew(system);
        solve_solve(system, b, x, false);
        team_expect(team, solve_report(system)->set_ups == 3, "a new preconditioner where it is asked for");
        totals_expect(team, solve, system);
    }
    solve_destroy(&system);
    if (solve != NULL)
        team_expect(team,
                    solve_total(solve, "test_")->solves == 6 && solve_total(solve, "other_")->solves == 0,
                    "the course of a system that is no more");
    solve_end(&solve, NULL, 0);
    lattice_matrix_free(&lattice);
    memory_free(b);
    memory_free(x);
    memory_free(before);
    team_finish(team);
}

/* A wrong name is the user's error, told apart; unused options are named. */
/* A hard matrix after an easy one: a new preconditioner is compared with its own first solve, not with that of the old one. */
static void renewed_counts_anew(void **state) {
    struct team *team = *state;
    struct error error = {0};
    struct solve *solve = lattice_matrix_begin(team, NULL);
    struct lattice_matrix lattice = {.dimension = 2, .side = 24};
    struct solve_options options = solve_options_regular("test_");
    options.reuse = 5;
    lattice_matrix_make(&lattice, &team->comm);
    struct solve_rows rows = lattice_matrix_rows(&lattice);
    double *b = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    double *x = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    double *value = memory_allocate((size_t)rows.start[rows.count], sizeof(double), "lattice");
    struct solve_system *system = solve != NULL ? solve_create(solve, &rows, &options, &error) : NULL;
    team_expect(team, system != NULL, "%s", error.text);
    int iterations[3] = {0};
    for (int turn = 0; system != NULL && turn < 3;
         turn++) { /* diagonals 50 times, then by a hundredth larger */
        for (int32_t k = 0; k < rows.start[rows.count]; k++)
            value[k] = lattice.value[k] * (fabs(lattice.value[k]) > 2 ? (turn == 0 ? 50 : 1.01) : 1);
        if (turn == 1)
            solve_renew(system);
        solve_values(system, value);
        lattice_matrix_sides(&lattice, b, x);
        solve_solve(system, b, x, false);
        iterations[turn] = (int)solve_report(system)->iterations;
    }
    if (system != NULL) {
        const struct solve_report *report = solve_report(system);
        team_expect(team, iterations[1] > 2 * iterations[0] + 1, "%d and %d iterations", iterations[0],
                    iterations[1]);
        lattice_matrix_sides(&lattice, b, x);
        solve_values(system, value);
        solve_solve(system, b, x, false);
        team_expect(team, report->set_ups == 2 && report->kept == 2, "%d set-ups, %d kept",
                    (int)report->set_ups, (int)report->kept);
    }
    solve_destroy(&system);
    solve_end(&solve, NULL, 0);
    lattice_matrix_free(&lattice);
    memory_free(b);
    memory_free(x);
    memory_free(value);
    team_finish(team);
}

static void options_reach_petsc(void **state) {
    struct team *team = *state;
    struct solve *solve = lattice_matrix_begin(
        team, "-test_ksp_type richardson -test_ksp_max_it 3 -wrong_ksp_type nonsense -idle 1");
    struct lattice_matrix lattice = {.dimension = 2, .side = 24, .shift = 1};
    lattice_matrix_make(&lattice, &team->comm);
    struct solve_rows rows = lattice_matrix_rows(&lattice);
    static const char *const wrong[2][2] = {{"ilut", "no preconditioner 'ilut'"}, {"jacobi", "nonsense"}};
    for (int k = 0; solve != NULL && k < 2; k++) {
        struct error error = {0};
        struct solve_options options = solve_options_regular("wrong_");
        options.preconditioner = wrong[k][0];
        struct solve_system *system = solve_create(solve, &rows, &options, &error);
        team_expect(team, system == NULL && error.kind == ERROR_USER && strstr(error.text, wrong[k][1]), "%s",
                    error.text);
    }
    if (solve != NULL) {
        struct error error = {0};
        struct solve_options options = solve_options_regular("test_");
        struct solve_system *system = solve_create(solve, &rows, &options, &error);
        double *b = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
        double *x = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
        lattice_matrix_sides(&lattice, b, x);
        bool converged = solve_solve(system, b, x, false);
        team_expect(team, !converged && solve_report(system)->iterations == 3, "%s after %d iterations",
                    solve_report(system)->reason, solve_report(system)->iterations);
        team_expect(team, solve_report(system)->doubtful == 1 && solve_report(system)->doubt > SOLVE_DOUBT,
                    "a residual of %g is in doubt", solve_report(system)->residual);
        solve_destroy(&system);
        memory_free(b);
        memory_free(x);
    }
    char unused[256] = "";
    solve_end(&solve, unused, sizeof unused);
    team_expect(team, strcmp(unused, "-idle") == 0, "unused: '%s'", unused);
    lattice_matrix_free(&lattice);
    team_finish(team);
}

/* An operator and a preconditioner by callback: those of a system with a matrix. */
struct borrowed {
    struct solve_system *system;
    int asked;
};

static void multiply(void *context, const double *x, double *y) {
    solve_multiply(((struct borrowed *)context)->system, x, y);
}

static void precondition(void *context, const double *r, double *z) {
    solve_cycle(((struct borrowed *)context)->system, r, z);
}

static bool enough(void *context, int iteration, const double *x, double residual_now) {
    (void)iteration, (void)x, (void)residual_now;
    return ++((struct borrowed *)context)->asked == 2;
}

static void without_a_matrix(void **state) {
    struct team *team = *state;
    struct error error = {0};
    struct solve *solve = lattice_matrix_begin(team, NULL);
    struct lattice_matrix lattice = {.dimension = 2, .side = 48, .shift = 0.01};
    lattice_matrix_make(&lattice, &team->comm);
    struct solve_rows rows = lattice_matrix_rows(&lattice);
    struct solve_options options = solve_options_regular("test_");
    options.preconditioner = "boomeramg";
    struct borrowed borrowed = {.system =
                                    solve != NULL ? solve_create(solve, &rows, &options, &error) : NULL};
    double *b = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    double *x = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    for (int turn = 0; borrowed.system != NULL && turn < 2; turn++) {
        struct solve_free work = {rows.count, &borrowed, multiply, precondition, turn == 1 ? enough : NULL,
                                  2};
        options.method = "gmres";
        options.prefix = "free_";
        struct solve_system *system = solve_create_free(solve, &work, &options, &error);
        team_expect(team, system != NULL, "%s", error.text);
        lattice_matrix_sides(&lattice, b, x);
        bool converged = system != NULL && solve_solve(system, b, x, false);
        double r = lattice_matrix_residual(&lattice, &team->comm, b, x);
        team_expect(team, converged && (turn == 1 || r < 1e-5), "residual %g", r);
        team_expect(team, turn == 0 || solve_report(system)->iterations == 4, "%d iterations, not 4",
                    solve_report(system)->iterations);
        solve_destroy(&system);
    }
    solve_destroy(&borrowed.system);
    solve_end(&solve, NULL, 0);
    lattice_matrix_free(&lattice);
    memory_free(b);
    memory_free(x);
    team_finish(team);
}

TEAM_MAIN(solve_interface, team_case(values_are_refilled), team_case(renewed_counts_anew),
          team_case(options_reach_petsc), team_case(without_a_matrix))
