/* SPDX-License-Identifier: BSD-3-Clause */
/* Simulations whose fluid waits for its first step. Read fluid_run.h first. */
#include "fluid_run.h"
#include "data/scene/scene_read.h"
#include "engine/simulation.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/schemes/solver_watch.h"

static const struct physics_context *context_of(const struct physics_set *set) {
    for (int k = 0; k < set->count; k++)
        if (set->active[k].number == PHYSICS_fluid)
            return &set->active[k].context;
    return NULL;
}

static bool solvers_make(const struct physics_context *context, struct error *error) {
    struct fluid *fluid = context->self;
    const struct fluid_options *options = fluid->options;
    const struct projection_options wanted = {.density = options->density,
                                              .viscosity = options->viscosity,
                                              .spacing = options->spacing,
                                              .dt = grain_dt(context),
                                              .advection = options->equations == FLUID_NAVIER_STOKES,
                                              .preconditioner = "boomeramg",
                                              .tolerance_velocity = 1e-10,
                                              .tolerance_pressure = 1e-10};
    fluid->projection = projection_create(fluid->solve, &fluid->flow, &wanted, error);
    return fluid->projection != NULL;
}

bool fluid_run_make(struct fluid_run *run, const struct comm *comm, const char *text, bool solvers) {
    *run = (struct fluid_run){0};
    run->scene = scene_parse("scene", text, NULL, 0, &run->error);
    if (run->scene != NULL)
        run->simulation = simulation_create(comm, run->scene, NULL, &run->error);
    if (run->simulation == NULL)
        return false;
    run->context = context_of(&run->simulation->physics);
    run->fluid = run->context->self;
    run->clock = &run->simulation->clock;
    run->clock->step = 1;
    run->clock->time = run->clock->dt;
    if (!solver_watch_begin(run->context)) {
        run->error = run->fluid->error;
        return false;
    }
    return !solvers || solvers_make(run->context, &run->error);
}

void fluid_run_free(struct fluid_run *run) {
    simulation_destroy(&run->simulation);
    if (run->scene != NULL)
        scene_free(&run->scene);
}

double fluid_run_momentum(const struct fluid_run *run, int d) {
    const struct fluid *fluid = run->fluid;
    double sum = 0;
    for (size_t row = 0; row < fluid->weights.rows; row++)
        sum += fluid->options->density * fluid->weights.volume[row] * flow_velocity_of(&fluid->flow, row)[d];
    comm_sum(run->context->comm, &sum, 1);
    return sum;
}
