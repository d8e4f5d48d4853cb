/* SPDX-License-Identifier: BSD-3-Clause */
/* Linear systems of lattices: the true residual, computed here from the rows, on all preconditioners.
 * Ranks: 1 2 3 4 8 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "core/memory.h"
#include "solve/solve.h"
#include "team.h"

#include <math.h>
#include <string.h>

static const char *const preconditioners[] = {"boomeramg", "gamg", "ml", "ilu", "sor", "jacobi", "none"};
enum { PRECONDITIONERS = 7, LINKS_MAX = 6 };

/* The negative Laplacian of a periodic lattice of `side` points in each direction, plus `shift` times one. Edges
 * weigh 1, or between 1 and 1 + spread; with `halves` no edge crosses the planes that divide the lattice, across
 * x, in two. The rows are dealt out evenly, and edge 24 is a multiple of all rank counts. */
struct lattice {
    int dimension, side;
    double spread, shift;
    bool halves;
    int32_t all, first, count; /* rows: of all, first of this rank, of this rank */
    int32_t *start, *column, *region;
    double *value;
};

/* A number in [0, 1) of two numbers in any order. */
static double draw(int32_t a, int32_t b) {
    uint64_t low = (uint64_t)(a < b ? a : b), high = (uint64_t)(a < b ? b : a);
    uint64_t h = (low * 0x9E3779B97F4A7C15u) ^ (high * 0xC2B2AE3D27D4EB4Fu);
    h = (h ^ (h >> 29)) * 0xBF58476D1CE4E5B9u;
    return (double)((h ^ (h >> 32)) >> 11) * 0x1p-53;
}

static int32_t neighbour(const struct lattice *lattice, int32_t row, int direction) {
    int32_t stride = 1, side = lattice->side;
    for (int d = 0; d < direction / 2; d++)
        stride *= side;
    int32_t c = row / stride % side, to = (c + (direction % 2 ? 1 : side - 1)) % side;
    if (lattice->halves && direction < 2 && (2 * c < side) != (2 * to < side))
        return -1;
    return row + (to - c) * stride;
}

static void fill_row(struct lattice *lattice, int32_t row, int32_t *used) {
    int32_t column[LINKS_MAX + 1], n = 0;
    double diagonal = lattice->shift;
    for (int k = 0; k < 2 * lattice->dimension; k++) {
        int32_t other = neighbour(lattice, row, k);
        if (other >= 0)
            column[n++] = other;
    }
    column[n++] = row;
    for (int a = 1; a < n; a++)
        for (int b = a; b > 0 && column[b] < column[b - 1]; b--) {
            int32_t swap = column[b];
            column[b] = column[b - 1];
            column[b - 1] = swap;
        }
    int32_t own = -1;
    for (int k = 0; k < n; k++) {
        double weight = 1 + lattice->spread * draw(row, column[k]);
        lattice->column[*used + k] = column[k];
        lattice->value[*used + k] = -weight;
        if (column[k] == row)
            own = *used + k;
        else
            diagonal += weight;
    }
    lattice->value[own] = diagonal;
    *used += n;
}

static void lattice_make(struct lattice *lattice, const struct comm *comm) {
    lattice->all = lattice->side * lattice->side * (lattice->dimension == 3 ? lattice->side : 1);
    lattice->count = lattice->all / comm->size;
    lattice->first = lattice->count * comm->rank;
    size_t n = (size_t)lattice->count;
    lattice->start = memory_allocate(n + 1, sizeof(int32_t), "lattice");
    lattice->column = memory_allocate(n * (LINKS_MAX + 1), sizeof(int32_t), "lattice");
    lattice->value = memory_allocate(n * (LINKS_MAX + 1), sizeof(double), "lattice");
    lattice->region = memory_allocate(n, sizeof(int32_t), "lattice");
    int32_t used = 0;
    for (int32_t i = 0; i < lattice->count; i++) {
        int32_t row = lattice->first + i;
        lattice->start[i] = used;
        lattice->region[i] = lattice->halves && 2 * (row % lattice->side) >= lattice->side;
        fill_row(lattice, row, &used);
    }
    lattice->start[lattice->count] = used;
}

static void lattice_free(struct lattice *lattice) {
    memory_free(lattice->start);
    memory_free(lattice->column);
    memory_free(lattice->value);
    memory_free(lattice->region);
}

static struct solve_rows lattice_rows(const struct lattice *lattice) {
    return (struct solve_rows){lattice->count, lattice->start, lattice->column, lattice->value};
}

/* |b - A x| / |b| from the rows, without the pin. */
static double residual(const struct lattice *lattice, const struct comm *comm, const double *b,
                       const double *x) {
    double *all = memory_allocate((size_t)lattice->all, sizeof(double), "lattice"), sum[2] = {0, 0};
    comm_gather_all(comm, x, (size_t)lattice->count * sizeof(double), all);
    for (int32_t i = 0; i < lattice->count; i++) {
        double r = b[i];
        for (int32_t k = lattice->start[i]; k < lattice->start[i + 1]; k++)
            r -= lattice->value[k] * all[lattice->column[k]];
        sum[0] += r * r;
        sum[1] += b[i] * b[i];
    }
    comm_sum(comm, sum, 2);
    memory_free(all);
    return sqrt(sum[0] / sum[1]);
}

/* The largest mean of x over a region. */
static double largest_mean(const struct lattice *lattice, const struct comm *comm, const double *x) {
    double sum[2] = {0, 0};
    for (int32_t i = 0; i < lattice->count; i++)
        sum[lattice->region[i]] += x[i] / lattice->all;
    comm_sum(comm, sum, 2);
    return fmax(fabs(sum[0]), fabs(sum[1]));
}

static void draw_sides(const struct lattice *lattice, double *b, double *x) {
    for (int32_t i = 0; i < lattice->count; i++) {
        b[i] = draw(lattice->first + i, -7) + lattice->region[i];
        x[i] = 0;
    }
}

/* Solves with b of random numbers, checks against the rows, and returns the iterations. */
static int try(struct team *team, struct solve *solve, const struct lattice *lattice,
               const struct solve_options *options) {
    struct error error = {0};
    struct solve_rows rows = lattice_rows(lattice);
    struct solve_system *system = solve_create(solve, &rows, options, &error);
    double *b = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    double *x = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    int iterations = 0;
    team_expect(team, system != NULL, "%s", error.text);
    if (system != NULL) {
        draw_sides(lattice, b, x);
        if (lattice->shift == 0)
            solve_null_space(system, lattice->halves ? 2 : 1, lattice->halves ? lattice->region : NULL);
        bool converged = solve_solve(system, b, x, false);
        const struct solve_report *report = solve_report(system);
        double r = residual(lattice, &team->comm, b, x), mean = largest_mean(lattice, &team->comm, x);
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

static struct solve *begin(struct team *team, const char *options) {
    struct error error = {0};
    if (!solve_available())
        team_skip(team, "PETSc is not there");
    struct solve *solve = solve_begin(&team->comm, options, &error);
    team_expect(team, solve != NULL, "%s", error.text);
    return solve;
}

/* All that is checked of a solution is in `try`; a lattice serves all preconditioners. */
static void try_all(struct team *team, struct lattice lattice, const char *method) {
    struct solve *solve = begin(team, NULL);
    if (solve != NULL) {
        lattice_make(&lattice, &team->comm);
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
        lattice_free(&lattice);
    }
    solve_end(&solve, NULL, 0);
    team_finish(team);
}

static void periodic_poisson(void **state) {
    try_all(*state, (struct lattice){.dimension = 2, .side = 48}, "fgmres");
    try_all(*state, (struct lattice){.dimension = 3, .side = 24}, "fgmres");
}

static void perturbed_poisson(void **state) {
    try_all(*state, (struct lattice){.dimension = 3, .side = 24, .spread = 3}, "fgmres");
    try_all(*state, (struct lattice){.dimension = 2, .side = 48, .spread = 3}, "gmres");
}

static void two_regions(void **state) {
    try_all(*state, (struct lattice){.dimension = 2, .side = 48, .halves = true}, "fgmres");
    try_all(*state, (struct lattice){.dimension = 3, .side = 24, .halves = true, .spread = 1}, "fgmres");
}

static void helmholtz(void **state) {
    try_all(*state, (struct lattice){.dimension = 3, .side = 24, .shift = 0.5}, "bicgstab");
    try_all(*state, (struct lattice){.dimension = 2, .side = 48, .shift = 0.05, .spread = 1}, "cg");
}

/* Four times the rows, or eight, and hardly more iterations. */
static void iterations_are_flat(void **state) {
    struct team *team = *state;
    struct solve *solve = begin(team, NULL);
    static const int sides[2][2] = {{48, 192}, {24, 48}};
    for (int d = 0; solve != NULL && d < 2; d++) {
        int iterations[2];
        for (int k = 0; k < 2; k++) {
            struct lattice lattice = {.dimension = d + 2, .side = sides[d][k], .spread = 0.5};
            struct solve_options options = solve_options_singular("test_");
            options.tolerance = 1e-6;
            lattice_make(&lattice, &team->comm);
            iterations[k] = try(team, solve, &lattice, &options);
            lattice_free(&lattice);
        }
        team_expect(team, iterations[0] <= 12 && iterations[1] <= iterations[0] + 3,
                    "iterations %d, then %d, in %d dimensions", iterations[0], iterations[1], d + 2);
    }
    solve_end(&solve, NULL, 0);
    team_finish(team);
}

/* |b - A x - g D| / |b| from the rows, with the diagonal D and the best g. */
static double residual_beside_diagonal(const struct lattice *lattice, const struct comm *comm,
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
    struct solve *solve = begin(team, NULL);
    struct lattice lattice = {.dimension = 2, .side = 48};
    struct solve_options options = solve_options_singular("test_");
    lattice_make(&lattice, &team->comm);
    struct solve_rows rows = lattice_rows(&lattice);
    double *b = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    double *x = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    for (int32_t i = 0; i < rows.count; i++)
        for (int32_t k = lattice.start[i]; k < lattice.start[i + 1]; k++)
            lattice.value[k] *= 1 + draw(lattice.first + i, -9);
    struct solve_system *system = solve != NULL ? solve_create(solve, &rows, &options, &error) : NULL;
    team_expect(team, system != NULL, "%s", error.text);
    if (system != NULL) {
        draw_sides(&lattice, b, x);
        solve_null_space(system, 1, NULL);
        bool converged = solve_solve(system, b, x, false);
        double r = residual_beside_diagonal(&lattice, &team->comm, b, x),
               whole = residual(&lattice, &team->comm, b, x);
        team_expect(team, converged && r < 10 * options.tolerance && whole > 5e-4, "residuals %g, %g", r,
                    whole);
        team_expect(
            team, solve_report(system)->residual < 10 * options.tolerance && !solve_report(system)->doubtful,
            "reported residual %g", solve_report(system)->residual);
        team_expect(team, largest_mean(&lattice, &team->comm, x) < 1e-9, "the mean is 0");
    }
    solve_destroy(&system);
    solve_end(&solve, NULL, 0);
    lattice_free(&lattice);
    memory_free(b);
    memory_free(x);
    team_finish(team);
}

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
    struct solve *solve = begin(team, NULL);
    struct lattice lattice = {.dimension = 2, .side = 48};
    struct solve_options options = solve_options_singular("test_");
    options.reuse = 2;
    options.tolerance = 1e-8;
    lattice_make(&lattice, &team->comm);
    struct solve_rows rows = lattice_rows(&lattice);
    struct solve_system *system = solve != NULL ? solve_create(solve, &rows, &options, &error) : NULL;
    double *b = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    double *x = memory_allocate((size_t)rows.count, sizeof(double), "lattice");
    double *before = memory_allocate_zero((size_t)rows.count, sizeof(double), "lattice");
    team_expect(team, system != NULL, "%s", error.text);
    if (system != NULL)
        solve_null_space(system, 1, NULL);
    for (int turn = 0; system != NULL && turn < 5; turn++) {
        draw_sides(&lattice, b, x);
        solve_solve(system, b, x, false);
        double r = residual(&lattice, &team->comm, b, x), difference = 0;
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
    lattice_free(&lattice);
    memory_free(b);
    memory_free(x);
    memory_free(before);
    team_finish(team);
}

/* A wrong name is the user's error, told apart; unused options are named. */
static void options_reach_petsc(void **state) {
    struct team *team = *state;
    struct solve *solve =
        begin(team, "-test_ksp_type richardson -test_ksp_max_it 3 -wrong_ksp_type nonsense -idle 1");
    struct lattice lattice = {.dimension = 2, .side = 24, .shift = 1};
    lattice_make(&lattice, &team->comm);
    struct solve_rows rows = lattice_rows(&lattice);
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
        draw_sides(&lattice, b, x);
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
    lattice_free(&lattice);
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
    struct solve *solve = begin(team, NULL);
    struct lattice lattice = {.dimension = 2, .side = 48, .shift = 0.01};
    lattice_make(&lattice, &team->comm);
    struct solve_rows rows = lattice_rows(&lattice);
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
        draw_sides(&lattice, b, x);
        bool converged = system != NULL && solve_solve(system, b, x, false);
        double r = residual(&lattice, &team->comm, b, x);
        team_expect(team, converged && (turn == 1 || r < 1e-5), "residual %g", r);
        team_expect(team, turn == 0 || solve_report(system)->iterations == 4, "%d iterations, not 4",
                    solve_report(system)->iterations);
        solve_destroy(&system);
    }
    solve_destroy(&borrowed.system);
    solve_end(&solve, NULL, 0);
    lattice_free(&lattice);
    memory_free(b);
    memory_free(x);
    team_finish(team);
}

int main(int argc, char **argv) {
    struct team team;
    team_start(&team, &argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(periodic_poisson, &team),
        cmocka_unit_test_prestate(perturbed_poisson, &team),
        cmocka_unit_test_prestate(two_regions, &team),
        cmocka_unit_test_prestate(helmholtz, &team),
        cmocka_unit_test_prestate(iterations_are_flat, &team),
        cmocka_unit_test_prestate(columns_need_not_sum_to_zero, &team),
        cmocka_unit_test_prestate(values_are_refilled, &team),
        cmocka_unit_test_prestate(options_reach_petsc, &team),
        cmocka_unit_test_prestate(without_a_matrix, &team),
    };
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    return team_stop(&team) + failed;
}
