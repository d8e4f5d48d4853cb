/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains between the steps of the fluid. Read rigid_motion.h first. */
#include "physics/fluid/coupling/rigid_motion.h"
#include "base/memory.h"
#include "kernel/particles/kinds.h"
#include "kernel/particles/spin.h"
#include "physics/grains/grains.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/fluid_state.h"
#include <math.h>
#include <string.h>

static const double *force_on(const struct particles *p, size_t i) {
    return p->force + i * (size_t)p->force_stride;
}

/* The motion of a grain that the fluid does not know yet is its own. */
static void motion_begin(const struct particles *p, size_t i) {
    double(*spin)[4] = spin_of(p), *motion = rigid_fields_motion(p)[i];
    if (!isnan(motion[0]))
        return;
    memset(motion, 0, 12 * sizeof *motion);
    memcpy(motion, p->state[i].v, 3 * sizeof *motion);
    if (spin != NULL)
        memcpy(motion + 3, spin[i], 3 * sizeof *motion);
}

/* Adds the momentum of a time to that of grain i; `push`: this part of the force is none of contacts. */
static void momentum_add(const struct particles *p, size_t i, double time, const double push[3]) {
    const double *force = force_on(p, i);
    double *impulse = rigid_fields_impulse(p)[i], contact[3];
    for (int d = 0; d < 3; d++) {
        contact[d] = force[d] - push[d];
        impulse[d] += time * contact[d];
        impulse[3 + d] += spin_of(p) != NULL ? time * force[4 + d] : 0;
    }
    impulse[RIGID_TOUCHED] = contact[0] != 0 || contact[1] != 0 || contact[2] != 0;
}

void rigid_motion_gather(const struct physics_context *context) {
    const struct particles *p = context->particles;
    const double dt = grain_due(context) ? 0.5 * context->clock->dt : context->clock->dt, none[3] = {0};
    struct kind_span span = kinds_span(p, context->classes, KIND_GRAIN);
    for (size_t i = span.first; i < span.end; i++) {
        motion_begin(p, i);
        if (!grains_solved(context))
            momentum_add(p, i, dt, none);
    }
}

bool rigid_motion_solved(const struct physics_context *context) {
    return fluid_rigid(context->options) && grains_solved(context);
}

void rigid_motion_gather_solved(const struct physics_context *context) {
    const struct particles *p = context->particles;
    const double dt = context->clock->step == 1 ? 0.5 * context->clock->dt : context->clock->dt;
    struct kind_span span = kinds_span(p, context->classes, KIND_GRAIN);
    for (size_t i = span.first; i < span.end; i++)
        momentum_add(p, i, dt, fluid_push(p)[i]);
}

/* The time from the velocities that grains store to those that the fluid finds: none where a solver finds the forces of contacts for these velocities. */
static double half_of(const struct physics_context *context) {
    return grains_solved(context) ? 0 : 0.5 * context->clock->dt;
}

/* What is added to the force of contacts on grain i. */
static void push_of(const struct physics_context *context, size_t i, double push[3]) {
    const struct fluid_options *options = context->options;
    const struct particle_state *state = &context->particles->state[i];
    bool touched = rigid_fields_impulse(context->particles)[i][RIGID_TOUCHED] != 0;
    double mass =
        touched ? options->density * grain_displaced(context, state->radius) : 1 / state->inverse_mass;
    for (int d = 0; d < 3; d++)
        push[d] = d < context->box->dimension ? -mass * context->scene->gravity[d] : 0;
}

/* Velocity and spin at half a step of the grains before those that the fluid found. */
static void set(const struct physics_context *context, size_t i, double jump[6]) {
    const struct particles *p = context->particles;
    struct particle_state *state = &p->state[i];
    const double *force = force_on(p, i), *motion = rigid_fields_motion(p)[i];
    double(*spin)[4] = spin_of(p), half = half_of(context), push[3];
    push_of(context, i, push);
    for (int d = 0; d < context->box->dimension; d++) {
        double v =
            motion[d] - half * ((force[d] + push[d]) * state->inverse_mass + context->scene->gravity[d]);
        jump[d] = v - state->v[d];
        state->v[d] = v;
    }
    for (int d = 0; spin != NULL && d < 3; d++) {
        double w =
            motion[3 + d] - half * force[4 + d] * 2.5 * state->inverse_mass / (state->radius * state->radius);
        jump[3 + d] = w - spin[i][d];
        spin[i][d] = w;
    }
}

void rigid_motion_set(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    const struct particles *p = context->particles;
    struct kind_span span = kinds_span(p, context->classes, KIND_GRAIN);
    const double half = half_of(context);
    memory_free(fluid->jump);
    fluid->jump = memory_allocate_zero(p->owned, sizeof *fluid->jump, "grains in a fluid");
    for (size_t i = span.first; i < span.end; i++) {
        const double *force = force_on(p, i);
        double *impulse = rigid_fields_impulse(p)[i];
        if (grain_moves(context, i))
            set(context, i, fluid->jump[i]);
        for (int d = 0; d < 3; d++) { /* the half of the next step of the fluid */
            impulse[d] = half * force[d];
            impulse[3 + d] = spin_of(p) != NULL ? half * force[4 + d] : 0;
        }
    }
}

void rigid_motion_apply(const struct physics_context *context) {
    const struct particles *p = context->particles;
    struct kind_span span = kinds_span(p, context->classes, KIND_GRAIN);
    const double none[3] = {0};
    for (size_t i = span.first; i < span.end; i++) {
        double push[3];
        if (!grain_moves(context, i))
            continue;
        push_of(context, i, push);
        grain_add(context, i, push, none);
    }
    grain_jumped(context->self);
}
