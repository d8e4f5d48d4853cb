/* SPDX-License-Identifier: BSD-3-Clause */
/* What a run learns of its solvers: the place of a failure, doubtful solves by the three guards, rows of the report.
 * Ranks: 1 2 */
#include "tests/test.h"

#include "base/memory.h"
#include "engine/report_part.h"
#include "lattice_matrix.h"
#include "physics/fluid/fluid_state.h"
#include "physics/fluid/schemes/solver_watch.h"

#include <string.h>

/* A fluid without particles, and what it says. */
struct room {
    struct fluid_options options;
    struct scene scene;
    struct clock clock;
    struct fluid fluid;
    struct log log;
    struct physics_context context;
    int lines;
    char line[512];
};

static void hear(void *context, const char *line) {
    struct room *r = context;
    r->lines++;
    snprintf(r->line, sizeof r->line, "%s", line);
}

/* A solver that makes two iterations and calls them enough. */
static void room_make(struct room *r, struct team *team, enum scene_guard guard) {
    *r = (struct room){.clock = {.step = 42, .time = 0.125}};
    if (!solve_available())
        team_skip(team, "PETSc is not there");
    snprintf(r->options.solver.petsc, sizeof r->options.solver.petsc, "%s",
             "-fluid_p_ksp_convergence_test skip -fluid_p_ksp_max_it 2");
    r->scene.guards.residual = guard;
    r->log = (struct log){hear, r};
    r->fluid.options = &r->options;
    r->context = (struct physics_context){.self = &r->fluid,
                                          .options = &r->options,
                                          .scene = &r->scene,
                                          .comm = &team->comm,
                                          .log = &r->log,
                                          .clock = &r->clock};
    team_expect(team, solver_watch_begin(&r->context), "%s", r->fluid.error.text);
    team_expect(team, r->fluid.first == (team->comm.rank == 0) && r->fluid.log == &r->log, "not begun");
}

/* Solves for a pressure that two iterations of Jacobi do not find, and for a velocity that is found. */
static void solve_both(struct room *r, struct team *team) {
    static const char *const prefix[2] = {"fluid_p_", "fluid_u_"};
    struct lattice_matrix lattice = {.dimension = 2, .side = 24, .shift = 1e-3};
    lattice_matrix_make(&lattice, &team->comm);
    double *b = memory_allocate((size_t)lattice.count, sizeof *b, "test");
    double *x = memory_allocate((size_t)lattice.count, sizeof *x, "test");
    for (int k = 0; k < 2; k++) {
        struct solve_options options = solve_options_regular(prefix[k]);
        struct solve_rows rows = lattice_matrix_rows(&lattice);
        struct solve_system *system = solve_create(r->fluid.solve, &rows, &options, &r->fluid.error);
        lattice_matrix_sides(&lattice, b, x);
        if (team_expect(team, system != NULL, "%s", r->fluid.error.text))
            solve_solve(system, b, x, false);
        solve_destroy(&system);
    }
    memory_free(b);
    memory_free(x);
    lattice_matrix_free(&lattice);
}

static bool says(const char *text, const char *part) {
    return strstr(text, part) != NULL;
}

/* An error of a solver gets step and time, once; what is no error of a solver stays as it is. */
static void failures_have_their_place(void **state) {
    struct team *team = *state;
    struct room r;
    room_make(&r, team, SCENE_GUARD_STOP);
    solver_watch_step(&r.context);
    team_expect(team, r.fluid.error.kind == ERROR_NONE, "%s", r.fluid.error.text);
    error_set(&r.fluid.error, ERROR_USER, "a wall moves");
    solver_watch_step(&r.context);
    team_expect(team, strcmp(r.fluid.error.text, "a wall moves") == 0, "%s", r.fluid.error.text);
    r.fluid.error = (struct error){0};
    error_set(&r.fluid.error, ERROR_PHYSICS, "no pressure");
    solver_watch_step(&r.context);
    team_expect(team, strcmp(r.fluid.error.text, "no pressure (step 42, t = 0.125)") == 0, "%s",
                r.fluid.error.text);
    r.fluid.error = (struct error){0};
    r.options.grains.motion = FLUID_GRAINS_FREE;
    r.options.grains.coupling = FLUID_MIRROR;
    error_set(&r.fluid.error, ERROR_PHYSICS, "no pressure");
    solver_watch_step(&r.context);
    team_expect(team, says(r.fluid.error.text, "(step 42, t = 0.125); where grains close pockets"), "%s",
                r.fluid.error.text);
    solve_end(&r.fluid.solve, NULL, 0);
    team_finish(team);
}

/* Off: nothing; warn: rank 0 says it once, however often it happens; stop: an error on all ranks. Solves before are not told again. */
static void doubtful_solves_are_told(void **state) {
    static const enum scene_guard guards[3] = {SCENE_GUARD_OFF, SCENE_GUARD_WARN, SCENE_GUARD_STOP};
    struct team *team = *state;
    struct room r;
    for (int k = 0; k < 3; k++) {
        room_make(&r, team, guards[k]);
        bool warns = guards[k] == SCENE_GUARD_WARN, stops = guards[k] == SCENE_GUARD_STOP;
        for (int n = 0; n < 2; n++) {
            r.fluid.error = (struct error){0};
            solve_both(&r, team);
            solver_watch_step(&r.context);
            team_expect(team, r.fluid.doubtful == n + 1, "%d doubtful solves", (int)r.fluid.doubtful);
            team_expect(team, r.lines == (warns && r.fluid.first), "%d lines", r.lines);
            team_expect(team, (r.fluid.error.kind == ERROR_PHYSICS) == stops, "guard %d: %s", k,
                        r.fluid.error.text);
        }
        const char *text = stops ? r.fluid.error.text : r.line;
        team_expect(team,
                    !(stops || r.lines > 0) ||
                        (says(text, "a solve for the pressure of the fluid") && says(text, "step 42")),
                    "%s", text);
        r.fluid.error = (struct error){0};
        solver_watch_step(&r.context);
        team_expect(team, r.fluid.error.kind == ERROR_NONE, "told again: %s", r.fluid.error.text);
        solve_end(&r.fluid.solve, NULL, 0);
    }
    team_finish(team);
}

/* The report has a row for each system with solves, of its name and its numbers; 24^2 rows with 5 entries each. */
static void the_report_has_the_systems(void **state) {
    struct team *team = *state;
    struct room r;
    struct report_part part = {0};
    room_make(&r, team, SCENE_GUARD_OFF);
    solver_watch_report(&r.context, &part);
    team_expect(team, part.solvers == 0, "%d rows before the first solve", part.solvers);
    for (int n = 0; n < 3; n++)
        solve_both(&r, team);
    solver_watch_report(&r.context, &part);
    const struct report_solver *velocity = &part.solver[0], *pressure = &part.solver[1];
    if (team_expect(team, part.solvers == 2, "%d rows", part.solvers)) {
        team_expect(team, strcmp(velocity->name, "velocity") == 0 && strcmp(pressure->name, "pressure") == 0,
                    "%s, %s", velocity->name, pressure->name);
        team_expect(team, velocity->solves == 3 && velocity->doubtful == 0 && velocity->rows == 24 * 24,
                    "velocity: %d solves", (int)velocity->solves);
        team_expect(team, pressure->entries == 5 * 24 * 24 && pressure->doubtful == 3, "pressure: %d entries",
                    (int)pressure->entries);
        team_expect(team, pressure->solves == 3 && pressure->iterations == 6, "pressure: %d iterations",
                    (int)pressure->iterations);
        team_expect(team, pressure->residual > 10 * velocity->residual, "residuals %g, %g",
                    pressure->residual, velocity->residual);
    }
    solve_end(&r.fluid.solve, NULL, 0);
    team_finish(team);
}

TEAM_MAIN(fluid_solver_watch, team_case(failures_have_their_place), team_case(doubtful_solves_are_told),
          team_case(the_report_has_the_systems))
