/* SPDX-License-Identifier: BSD-3-Clause */
/* The solvers of a fluid under a run's eyes. Read solver_watch.h first. */
#include "physics/fluid/schemes/solver_watch.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/fluid_state.h"
#include "engine/report_part.h"
#include <stdio.h>
#include <string.h>

/* The systems of the schemes: the prefix of their options, their name in the report. */
static const struct {
    const char *prefix, *name;
} systems[] = {{"fluid_u_", "velocity"}, {"fluid_p_", "pressure"}, {"fluid_s_", "steady"},
               {"fluid_c_", "scalars"},  {"fluid_f_", "fluxes"},   {"fluid_e_", "potential"}};
enum { SYSTEMS = sizeof systems / sizeof systems[0] };

bool solver_watch_begin(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    if (fluid->solve != NULL)
        return true;
    fluid->first = context->comm->rank == 0;
    fluid->log = context->log;
    timer_enter(context->timers, "other"); /* the library is loaded */
    fluid->solve = solve_begin(context->comm, fluid->options->solver.petsc, &fluid->error);
    timer_leave(context->timers, "other");
    if (fluid->solve != NULL)
        solve_charge(fluid->solve, context->timers);
    return fluid->solve != NULL;
}

/* Adds step and time to the error of a solver, and what else may stop a flow around grains that it moves. */
static void name_step(const struct physics_context *context, struct error *error) {
    char text[ERROR_TEXT_MAX];
    snprintf(text, sizeof text, "%s", error->text);
    *error = (struct error){0};
    error_set(error, ERROR_PHYSICS, "%s (step %llu, t = %.9g)%s", text,
              (unsigned long long)context->clock->step, context->clock->time,
              grain_pockets(context->options));
}

static void doubt(const struct physics_context *context, int system) {
    struct fluid *fluid = context->self;
    const struct solve_report *report = solve_total(fluid->solve, systems[system].prefix);
    enum scene_guard guard = context->scene->guards.residual;
    char text[320];
    snprintf(
        text, sizeof text,
        "guards.residual: the true residual of a solve for the %s of the fluid is %.3g times its tolerance, "
        "%.2g of the "
        "right-hand side, at step %llu, t = %.9g: the flow is less accurate than fluid.solver.tolerance says",
        systems[system].name, report->doubt, report->doubt * report->tolerance,
        (unsigned long long)context->clock->step, context->clock->time);
    if (guard == SCENE_GUARD_STOP)
        error_set(&fluid->error, ERROR_PHYSICS, "%s", text);
    else if (guard == SCENE_GUARD_WARN && fluid->first && fluid->doubtful == 0)
        log_tell(context->log, "warning: %s (said once)", text);
}

void solver_watch_step(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    if (fluid->error.kind == ERROR_PHYSICS)
        name_step(context, &fluid->error);
    int64_t doubtful = 0;
    int last = 0;
    for (int k = 0; fluid->solve != NULL && k < SYSTEMS; k++) {
        int64_t of_system = solve_total(fluid->solve, systems[k].prefix)->doubtful;
        doubtful += of_system;
        last = of_system > 0 ? k : last;
    }
    if (doubtful > fluid->doubtful)
        doubt(context, last);
    fluid->doubtful = doubtful;
}

void solver_watch_report(const struct physics_context *context, struct report_part *part) {
    const struct fluid *fluid = context->self;
    for (int k = 0; fluid->solve != NULL && k < SYSTEMS; k++) {
        const struct solve_report *report = solve_total(fluid->solve, systems[k].prefix);
        if (report->rows == 0)
            continue;
        part->solver[part->solvers++] = (struct report_solver){.name = systems[k].name,
                                                               .rows = (uint64_t)report->rows,
                                                               .entries = (uint64_t)report->entries,
                                                               .solves = (uint64_t)report->solves,
                                                               .iterations = (uint64_t)report->iterations_all,
                                                               .set_ups = (uint64_t)report->set_ups,
                                                               .kept = (uint64_t)report->kept,
                                                               .doubtful = (uint64_t)report->doubtful,
                                                               .products = (uint64_t)report->products,
                                                               .residual = report->residual,
                                                               .residual_worst = report->residual_worst,
                                                               .seconds_matrix = report->seconds_matrix,
                                                               .seconds_set_up = report->seconds_set_up,
                                                               .seconds_solve = report->seconds_solve,
                                                               .seconds_products = report->seconds_products};
    }
}
