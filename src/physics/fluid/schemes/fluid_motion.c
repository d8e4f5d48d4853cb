/* SPDX-License-Identifier: BSD-3-Clause */
/* Moves the particles of a fluid. Read fluid_motion.h first. */
#include "physics/fluid/schemes/fluid_motion.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/schemes/moving_step.h"
#include "physics/fluid/coupling/boundary_motion.h"
#include "physics/fluid/schemes/particle_shift.h"
#include "physics/fluid/fluid_state.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <string.h>

bool fluid_motion_moves(const struct fluid_options *options) {
    return options->motion.name != FLUID_FIXED;
}

unsigned fluid_motion_kinds(const void *options) {
    return fluid_motion_moves(options) ? 1u << KIND_FLUID : 0;
}

bool fluid_motion_needed(const struct physics_context *context) {
    return fluid_motion_moves(context->options);
}

bool fluid_motion_suits(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    const struct fluid_motion *motion = &options->motion;
    if (!fluid_motion_moves(options))
        return true;
    if (options->time != FLUID_TRANSIENT || options->equations != FLUID_NAVIER_STOKES)
        return scene_fail(context->scene, error, "fluid.motion",
                          "particles that move need equations: navier_stokes and time: transient; allowed "
                          "with others: fixed");
    for (int d = 0; d < context->box->dimension; d++)
        if (motion->name == FLUID_ALE && motion->velocity[d] != 0 && !context->box->periodic[d])
            return scene_fail(context->scene, error, "fluid.motion.velocity",
                              "points would leave the box along %c; allowed are velocities along periodic "
                              "directions",
                              'x' + d);
    return true;
}

void fluid_motion_given(const struct fluid_motion *motion, const struct box *box, const double x[3],
                        double time, double w[3]) {
    double omega = 2 * M_PI / motion->period, shape = omega * cos(omega * time);
    for (int d = 0; d < box->dimension; d++)
        shape *= sin((box->periodic[d] ? 2 : 1) * M_PI * x[d] / box->edge[d]);
    for (int d = 0; d < 3; d++)
        w[d] = d < box->dimension ? motion->velocity[d] + shape * motion->swing[d] : 0;
}

/* The velocity of a particle in the step that begins: that of the flow ahead, or the given one at the middle. */
static void velocity_of(const struct physics_context *context, size_t i, double ahead, double w[3]) {
    const struct fluid *fluid = context->self;
    const struct fluid_motion *motion = &fluid->options->motion;
    const double *x = context->particles->state[i].x;
    double dt = grain_dt(context), start = context->clock->time - dt, middle[3];
    if (motion->name == FLUID_LAGRANGIAN) {
        moving_step_velocity(&fluid->flow, i, ahead, w);
        return;
    }
    fluid_motion_given(motion, context->box, x, start, w);
    for (int d = 0; d < 3; d++)
        middle[d] = x[d] + 0.5 * dt * w[d];
    fluid_motion_given(motion, context->box, middle, start + 0.5 * dt, w);
}

double fluid_motion_move(const struct physics_context *context, int thread, size_t first, size_t last,
                         int size_class) {
    struct fluid *fluid = context->self;
    double dt = grain_dt(context), ahead = fluid->past.steps > 0 ? 0.5 * dt / fluid->past.dt : 0;
    double largest = 0, steps = (double)grain_every(context);
    (void)thread;
    if (!grain_due(context))
        return 0;
#pragma omp atomic write
    fluid->followed = context->clock->step;
    if (context->classes->kind[size_class] == KIND_BOUNDARY && fluid->riding)
        largest = boundary_move(context, first, last);
    if (context->classes->kind[size_class] != KIND_FLUID)
        return largest;
    for (size_t i = first; i < last; i++) {
        double w[3], square = 0;
        velocity_of(context, i, ahead, w);
        for (int d = 0; d < context->box->dimension; d++) {
            context->particles->state[i].x[d] += dt * w[d];
            square += steps * steps * w[d] * w[d];
        }
        if (!isnan(largest) && !(square <= largest))
            largest = square;
    }
    return largest;
}

/* The drift of points with a given velocity. */
static void drift_given(const struct physics_context *context) {
    const struct fluid *fluid = context->self;
    const struct weights *weights = &fluid->weights;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        size_t i = weights->first + row;
        double w[3];
        fluid_motion_given(&fluid->options->motion, context->box, context->particles->state[i].x,
                           context->clock->time, w);
        for (size_t d = 0; d < 3; d++)
            fluid->flow.drift[3 * i + d] = w[d] - context->particles->state[i].v[d];
    }
}

void fluid_motion_drift(const struct physics_context *context, double speed) {
    const struct fluid *fluid = context->self;
    const struct fluid_motion *motion = &fluid->options->motion;
    const struct particle_shift_options shift = {
        motion->shifting == FLUID_SHIFT_LIND ? motion->strength : 0, speed,
        FLUID_SHIFT_MOST * fluid->options->spacing / grain_dt(context)};
    if (motion->name == FLUID_ALE) {
        drift_given(context);
    } else {
        particle_shift_velocity(&fluid->weights, &fluid->input, &fluid->weigh, &shift, fluid->flow.drift);
        particle_shift_keep_off(&fluid->flow,
                                &(struct particle_shift_off){SHIFT_LEAST * fluid->options->spacing,
                                                             shift.most, grain_dt(context), 0.5});
    }
    moving_step_drift_advect(&fluid->flow);
}
