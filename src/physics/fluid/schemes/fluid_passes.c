/* SPDX-License-Identifier: BSD-3-Clause */
/* From rebuilds and steps of the engine to the flow: weights, matrices, steps. Read fluid_passes.h and flow.h first. */
#include "physics/fluid/schemes/fluid_passes.h"
#include "physics/grains/grains.h"
#include "base/checksum.h"
#include "base/memory.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/coupling/lubrication_pairs.h"
#include "physics/fluid/coupling/rigid_motion.h"
#include "physics/fluid/coupling/rigid_step.h"
#include "physics/fluid/coupling/surface_loads.h"
#include "physics/fluid/coupling/unresolved_grains.h"
#include "physics/fluid/coupling/unresolved_shares.h"
#include "physics/fluid/carried/electrolyte.h"
#include "physics/fluid/lattice/surface_feet.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/lattice/lattice_fill.h"
#include "physics/fluid/schemes/flow_fields.h"
#include "physics/fluid/coupling/coupled_solve.h"
#include "physics/fluid/flow_output.h"
#include "physics/fluid/schemes/flow_loss.h"
#include "physics/fluid/lattice/mirror.h"
#include "physics/fluid/schemes/fluid_motion.h"
#include "physics/fluid/schemes/moving_step.h"
#include "physics/fluid/coupling/boundary_motion.h"
#include "physics/fluid/carried/scalars.h"
#include "physics/fluid/fluid_state.h"
#include "physics/fluid/schemes/solver_watch.h"
#include "physics/fluid/operators/gradient_correction.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include "physics/grains/walls/wall.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Largest motion in a step, in spacings. */
#define COURANT 0.5

/* Time of a step in which nothing but the steady flow is looked for, in units of the scene. */
#define STEADY_STEP 1.0

/* What weights are made from, after a rebuild. */
static void input_of(const struct physics_context *context, struct fluid *fluid) {
    struct particles *p = context->particles;
    struct kind_span span = kinds_span(p, context->classes, KIND_FLUID);
    pair_rows_build(&fluid->pairs, context->list[0], p->owned);
    fluid->input = (struct weights_input){.particles = p,
                                          .kind = kinds_of(p),
                                          .first = span.first,
                                          .end = span.end,
                                          .pairs = &fluid->pairs,
                                          .shift = (const double(*)[4])context->list[0]->shift,
                                          .dimension = context->box->dimension,
                                          .volume = fluid_volume(p)};
    fluid->weigh = (struct weights_options){
        .kernel = kernel_make(fluid->options->kernel.name, fluid->support, context->box->dimension),
        .operators = fluid->options->operators.name,
        .order = fluid->options->operators.order,
        .spacing = fluid->options->spacing,
        .volume = fluid->volume,
        .slip = fluid_slip(fluid->options),
        .moving = fluid_motion_moves(fluid->options)};
}

/* The volumes of the rows, and those of the lattice for boundary particles, go to the copies. */
static void volumes_share(const struct physics_context *context, const struct fluid *fluid) {
    double *volume = fluid_volume(context->particles);
    if (volume == NULL)
        return;
    for (size_t k = 0; k < context->particles->owned; k++)
        volume[k] = fluid->lattice.volume;
    memcpy(volume + fluid->weights.first, fluid->weights.volume,
           fluid->weights.rows * sizeof *fluid->weights.volume);
    flow_fields_forward(context, FLOW_VOLUME);
}

/* True if a body is a grain or a mesh, which may leave narrow pores. */
static bool has_pores(const struct physics_context *context, int64_t body) {
    bool wall = body < BODY_NONE && body_side(body) < 0;
    return body > BODY_NONE || (wall && wall_shape_meshed(context->scene->wall[body_wall(body)].shape));
}

/* Weights and mirrors for the present places of the particles. */
static void weights_of(const struct physics_context *context, struct fluid *fluid) {
    struct particles *p = context->particles;
    timer_enter(context->timers, "operators");
    size_t without = fluid->riding ? boundary_settle(context, fluid) : 0;
    weights_rows(&fluid->weights, &fluid->input, &fluid->weigh);
    volumes_share(context, fluid);
    weights_weigh(&fluid->weights, &fluid->input, &fluid->weigh);
    fluid->lost = without + surface_feet_mirror(context, fluid);
    if (fluid_whole(p) != NULL)
        gradient_correction_make(&fluid->weights, &fluid->input, fluid_whole(p));
    timer_leave(context->timers, "operators");
    fluid->rows[0] = (double)fluid->weights.rows;
    fluid->rows[1] = (double)fluid->weights.poor;
    fluid->rows[2] = (double)fluid->weights.behind;
    fluid->rows[3] = 0;
    for (size_t k = 0; k < fluid->weights.foot_start[fluid->weights.rows]; k++)
        fluid->rows[3] += has_pores(context, fluid->weights.foot[k].body);
    comm_sum(context->comm, fluid->rows, 4);
    fluid->placed = context->clock->step;
}

/* A number that changes if the fluid and boundary particles of this rank, or their numbers, do. */
static uint64_t layout_of(const struct particles *p) {
    const uint8_t *kind = kinds_of(p);
    uint64_t sum = 1;
    for (size_t k = 0; k < p->owned + p->ghosts; k++) {
        const int64_t row[2] = {p->id[k], (int64_t)k};
        if (kind[k] == KIND_FLUID || kind[k] == KIND_BOUNDARY)
            sum = checksum_row(sum, row, sizeof row);
    }
    return sum ? sum : 1;
}

static int regions_of(const struct physics_context *context, const struct fluid *fluid) {
    const int32_t *region = fluid_region(context->particles);
    int64_t most = 0;
    for (size_t row = 0; row < fluid->weights.rows; row++)
        most = region[fluid->weights.first + row] > most ? region[fluid->weights.first + row] : most;
    comm_max_int(context->comm, &most, 1);
    return (int)most + 1;
}

/* True if the operators are those of gradient_correction.h: in a steady flow, and in time between grains or within meshes (planes and cylinders are large against the
 * spacing, and plain operators more accurate there), and where grains are averaged: the drop of a bed a few spacings wide is along walls. */
static bool whole_wanted(const struct fluid *fluid) {
    return fluid->options->time == FLUID_STEADY || fluid->rows[3] > 0 || unresolved_averaged(fluid->options);
}

void fluid_passes_rebuilt(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    uint64_t layout = layout_of(context->particles);
    int64_t changed = layout != fluid->layout || fluid_motion_moves(fluid->options);
    comm_max_int(context->comm, &changed, 1);
    if (fluid->layout == 0 && !fluid->filled)
        lattice_fill_kept_suits(context, &fluid->error);
    if (changed) {
        projection_destroy(&fluid->projection);
        steady_destroy(&fluid->steady);
        scalars_forget(fluid->scalars);
        electrolyte_forget(fluid->electrolyte);
        input_of(context, fluid);
        weights_of(context, fluid);
        fluid->regions = regions_of(context, fluid);
    } else if (unresolved_any(fluid->options) || fluid->rigid != NULL) {
        pair_rows_build(&fluid->pairs, context->list[0], context->particles->owned);
    }
    fluid->layout = layout;
    flow_fields_take(&fluid->flow, context, &fluid->weights, fluid->regions);
    fluid->flow.pressed = open_pressed(fluid->options);
    flow_forward(&fluid->flow, FLOW_VELOCITY);
    flow_forward(&fluid->flow, FLOW_PRESSURE);
    fluid->weights.whole = whole_wanted(fluid) ? fluid_whole(context->particles) : NULL;
    if (fluid->weights.whole != NULL)
        flow_forward(&fluid->flow, FLOW_WHOLE);
    if (unresolved_any(fluid->options) && context->clock->step == 0)
        unresolved_begin(context); /* the first limit of a step reads what grains see */
    if (fluid->rigid != NULL)
        rigid_step_pairs(context, fluid->rigid, &fluid->pairs);
    if (lubrication_wanted(context))
        lubrication_pairs_take(context, &fluid->pairs);
    if (changed) {
        flow_number(&fluid->flow);
        scalars_rebuilt(context);
        electrolyte_rebuilt(context);
    } else {
        flow_forward(&fluid->flow, FLOW_ROW);
    }
    if (!fluid_motion_moves(fluid->options) && !unresolved_any(fluid->options))
        pair_rows_free(&fluid->pairs);
    /* points move from the start; particles without a shift yet have no drift */
    if (fluid->options->motion.name == FLUID_ALE && fluid->past.steps == 0 &&
        context->clock->step == fluid->done)
        fluid_motion_drift(context, 0);
}

static const char *preconditioner_of(const struct fluid_options *options) {
    return options->solver.preconditioner == FLUID_GAMG ? "gamg" : "boomeramg";
}

static double tolerance_of(const struct fluid_options *options, double usual) {
    return isnan(options->solver.tolerance) ? usual : options->solver.tolerance;
}

/* The largest speed of the fluid. Collective. */
static double speed_largest(const struct physics_context *context) {
    const uint8_t *kind = kinds_of(context->particles);
    double square = 0;
    for (size_t k = 0; k < context->particles->owned; k++) {
        const double *v = context->particles->state[k].v;
        if (kind[k] == KIND_FLUID)
            square = fmax(square, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    comm_max(context->comm, &square, 1);
    return sqrt(square);
}

/* A step of particles that move, which their matrices fit. */
static void step_path(const struct physics_context *context, struct fluid *fluid, double dt) {
    const struct moving_step_push push = {fluid->drive.force, fluid->options->motion.filter};
    const struct path path = moving_step_begin(fluid->projection, &fluid->flow, &fluid->past, dt, &push);
    if (grain_free(fluid->options) ? !coupled_step(context, &path, &fluid->error)
                                   : !moving_step_try(&path, &fluid->error))
        return;
    fluid->past = (struct projection_past){fluid->past.steps + 1, dt};
    fluid_motion_drift(context, speed_largest(context));
}

/* A step in time; matrices and solvers are made where there are none. */
static void step_transient(const struct physics_context *context, struct fluid *fluid) {
    const struct fluid_options *options = fluid->options;
    const struct projection_options wanted = {.density = options->density,
                                              .viscosity = options->viscosity,
                                              .spacing = options->spacing,
                                              .dt = grain_dt(context),
                                              .advection = options->equations == FLUID_NAVIER_STOKES,
                                              .preconditioner = preconditioner_of(options),
                                              .tolerance_velocity = 1e-8,
                                              .tolerance_pressure = tolerance_of(options, 1e-5),
                                              .reuse = options->solver.reuse};
    bool old = fluid->projection != NULL, moves = fluid_motion_moves(options);
    double dt = grain_dt(context);
    if (!old)
        fluid->projection = projection_create(fluid->solve, &fluid->flow, &wanted, &fluid->error);
    if (fluid->projection == NULL)
        return;
    if (old && moves)
        projection_refill(fluid->projection, &fluid->flow);
    if (old && fluid->flow.mobility != NULL)
        projection_refill_pressure(fluid->projection, &fluid->flow);
    if (old && fluid->renew)
        projection_renew(fluid->projection);
    fluid->renew = false;
    /* the scheme of particles at rest has the force of the middle of a step, the other one that of its end */
    flow_drive_adjust(&fluid->drive, options, context->box, &fluid->flow,
                      context->clock->time - (moves ? 0 : 0.5 * dt), dt);
    if (fluid->rigid != NULL)
        rigid_step(context, &fluid->error);
    else if (!moves)
        projection_step(fluid->projection, &fluid->flow, &fluid->past, dt, fluid->drive.force, &fluid->error);
    else
        step_path(context, fluid, dt);
}

/* The steady flow at once, in the first step; the steps after it leave it as it is. */
static void step_steady(const struct physics_context *context, struct fluid *fluid) {
    const struct fluid_options *options = fluid->options;
    const struct steady_options wanted = {
        .viscosity = options->viscosity,
        .spacing = options->spacing,
        .edge = fmax(context->box->edge[0], fmax(context->box->edge[1], context->box->edge[2])),
        .tolerance = tolerance_of(options, 1e-3),
        .iterations = 1000,
        .preconditioner = preconditioner_of(options)};
    if (fluid->solved)
        return;
    if (fluid->steady == NULL)
        fluid->steady = steady_create(fluid->solve, &fluid->flow, &wanted, &fluid->error);
    if (fluid->steady != NULL)
        fluid->solved =
            steady_solve(fluid->steady, &fluid->flow, fluid->drive.force, &fluid->report, &fluid->error) &&
            flow_drive_scale(&fluid->drive, options, context->box, &fluid->flow, &fluid->error);
    steady_destroy(&fluid->steady); /* what comes after the solve needs memory, too */
}

/* Walls may slide within themselves: one that comes nearer or goes away is refused. */
static void walls_check(const struct physics_context *context, struct fluid *fluid, double moved) {
    comm_sum(context->comm, &moved, 1);
    if (moved > 0)
        error_set(
            &fluid->error, ERROR_USER,
            "fluid: a wall moves towards the fluid or away from it; allowed are walls that slide within "
            "themselves, as a lid does, and with fluid.grains: {coupling: rigid} from the start closed "
            "meshes, and cylinders "
            "with particles outside");
}

/* Walls that slide within themselves have new velocities and spins. */
static void walls_follow(const struct physics_context *context, struct fluid *fluid) {
    struct weights *weights = &fluid->weights;
    const struct feet feet = {grains_walls(context), fluid->options, context->box};
    const double same = 1e-6 * fluid->options->spacing;
    size_t moved = 0;
    if (grains_walls(context) == NULL || !walls_move(grains_walls(context)))
        return;
#pragma omp parallel for schedule(static) reduction(+ : moved)
    for (size_t row = 0; row < weights->rows; row++)
        for (size_t k = weights->foot_start[row]; k < weights->foot_start[row + 1]; k++) {
            struct weights_foot *foot = &weights->foot[k];
            struct weights_foot now = {0};
            double across = 0;
            if (foot->body >= 0 || body_side(foot->body) >= 0)
                continue;
            surface_feet_on(&feet, foot->body, context->particles->state[weights->first + row].x, &now);
            for (int d = 0; d < 3; d++)
                across += now.normal[d] * now.velocity[d] * context->clock->dt;
            moved += fabs(across) > same;
            memcpy(foot->velocity, now.velocity, sizeof foot->velocity);
            memcpy(foot->spin, now.spin, sizeof foot->spin);
        }
    mirror_turn(weights, &fluid->input);
    walls_check(context, fluid, (double)moved);
}

double fluid_passes_limit(const struct physics_context *context, double most) {
    const struct fluid *fluid = context->self;
    if (fluid->options->time == FLUID_STEADY)
        return fluid->scalars != NULL ? most : fmin(most, STEADY_STEP);
    if (fluid->options->equations == FLUID_STOKES)
        return most;
    double speed = fmax(speed_largest(context), open_speed(fluid->options));
    return speed > 0 ? fmin(most, COURANT * fluid->options->spacing / speed / (double)grain_every(context))
                     : most;
}

/* Stops a flow that has become too fast for its steps; twice the limit, as it may pass that for a while. */
static void check_speed(const struct physics_context *context, struct fluid *fluid) {
    const struct clock *clock = context->clock;
    double moved = speed_largest(context) * grain_dt(context) / fluid->options->spacing;
    if (moved > 2 * COURANT && !context->scene->step.force)
        error_set(
            &fluid->error, ERROR_PHYSICS,
            "fluid: the fluid moves by %.3g spacings in step %llu, t = %.9g; advection wants %g or less: "
            "shorten step.dt (or step.force: true)%s",
            moved, (unsigned long long)clock->step, clock->time, COURANT, grain_pockets(fluid->options));
}

static void step_run(const struct physics_context *context, struct fluid *fluid) {
    if (fluid_motion_moves(fluid->options) && fluid->placed != context->clock->step)
        weights_of(context, fluid);
    if (fluid_motion_moves(fluid->options) && grains_walls(context) != NULL &&
        walls_move(grains_walls(context)))
        walls_at_end(grains_walls(context), context->clock->time,
                     context->clock->dt); /* the scheme stands at the end of the step */
    walls_follow(context, fluid);
    if (fluid->error.kind != ERROR_NONE || !solver_watch_begin(context))
        return;
    if (unresolved_any(fluid->options))
        unresolved_act(context, grain_dt(context));
    if (fluid->electrolyte != NULL)
        electrolyte_step(context);
    if (fluid->error.kind == ERROR_NONE && fluid->options->time == FLUID_STEADY)
        step_steady(context, fluid);
    else if (fluid->error.kind == ERROR_NONE)
        step_transient(context, fluid);
    if (fluid->error.kind == ERROR_NONE && unresolved_any(fluid->options))
        unresolved_look(context, grain_dt(context));
    if (fluid->error.kind == ERROR_NONE && fluid->scalars != NULL)
        scalars_step(context, fluid->options->time == FLUID_TRANSIENT);
    solver_watch_step(context);
    if (fluid->error.kind == ERROR_NONE && fluid->options->time == FLUID_TRANSIENT &&
        fluid->options->opens > 0)
        flow_loss_watch(context);
    if (fluid->error.kind == ERROR_NONE && fluid->options->equations == FLUID_NAVIER_STOKES)
        check_speed(context, fluid);
}

void fluid_passes_step(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    if (fluid->error.kind != ERROR_NONE)
        return;
    bool due = context->clock->step != fluid->done && grain_due(context);
    if (unresolved_any(fluid->options))
        unresolved_give(context);
    if (fluid->rigid != NULL)
        rigid_motion_gather(context);
    if (due)
        step_run(context, fluid);
    fluid->done = context->clock->step;
    if (fluid->rigid != NULL && due && fluid->error.kind == ERROR_NONE)
        rigid_motion_set(context);
    if (fluid->rigid != NULL)
        rigid_motion_apply(context);
    else if (grain_free(fluid->options))
        grain_apply(context);
}

void fluid_passes_look(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    double *divergence = fluid_divergence(context->particles);
    operators_divergence(&fluid->weights, flow_velocity(&fluid->flow), divergence + fluid->weights.first);
    memcpy(fluid_condition(context->particles) + fluid->weights.first, fluid->weights.condition,
           fluid->weights.rows * sizeof *fluid->weights.condition);
    surface_loads_look(&fluid->forces, context, &fluid->flow, fluid->options->viscosity);
    if (fluid->rigid != NULL)
        rigid_step_look(context);
    flow_viscous(&fluid->flow, fluid->options->viscosity * fluid->lattice.volume,
                 fluid_drag(context->particles));
    flow_vorticity(&fluid->flow);
    if (fluid->scalars != NULL)
        scalars_look(context);
}

void fluid_passes_end(void *self) {
    struct fluid *fluid = self;
    char unused[256] = "";
    projection_destroy(&fluid->projection);
    steady_destroy(&fluid->steady);
    scalars_destroy(&fluid->scalars);
    electrolyte_destroy(&fluid->electrolyte);
    if (fluid->solve) {
        solve_end(&fluid->solve, unused, sizeof unused);
        if (fluid->first && unused[0])
            log_tell(fluid->log, "warning: fluid.solver.petsc: PETSc knows nothing to do with %s", unused);
    }
    flow_drive_free(&fluid->drive);
    weights_free(&fluid->weights);
    pair_rows_free(&fluid->pairs);
    surface_forces_free(&fluid->forces);
    if (fluid->rigid != NULL)
        rigid_step_free(fluid->rigid);
    memory_free(fluid->rigid);
    lubrication_pairs_destroy(&fluid->lubrication);
    unresolved_shares_destroy(&fluid->dust);
    memory_free(fluid->jump);
    memory_free(fluid->gaps);
    memory_free(fluid);
}
