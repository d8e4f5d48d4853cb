/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains between the steps of the fluid. Read rigid_motion.h first. */
#include "physics/fluid/coupling/rigid_motion.h"
#include "base/memory.h"
#include "physics/bodies/bodies_parts.h"
#include "physics/grains/grains.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/coupling/rigid_bodies.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/coupling/rigid_sums.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/fluid_state.h"
#include <math.h>
#include <string.h>

static struct rigid_inertia inertia_of(const struct physics_context *context, size_t i) {
    const struct fluid *fluid = context->self;
    return rigid_bodies_inertia(context, (const double(*)[2])fluid->rigid->section, i);
}

/* The motion of a grain that the fluid does not know yet is its own. */
static void motion_begin(const struct physics_context *context, size_t i) {
    double *motion = rigid_fields_motion(context->particles)[i],
           *held = rigid_fields_held(context->particles)[i], contact[6];
    if (!isnan(motion[0]))
        return;
    memset(motion, 0, 12 * sizeof *motion);
    rigid_bodies_motion(context, i, motion);
    const struct rigid_inertia inertia = inertia_of(context, i);
    rigid_bodies_contact(context, i, contact);
    bool touched = contact[0] != 0 || contact[1] != 0 || contact[2] != 0;
    memset(held, 0, 6 * sizeof *held);
    for (int d = 0; d < context->box->dimension && !touched; d++)
        held[d] = (inertia.displaced - inertia.mass) * context->scene->gravity[d];
}

/* Adds the momentum of a time to that of i; `push`: this part of the force and the torque is none of contacts. */
static void momentum_add(const struct physics_context *context, size_t i, double time, const double push[6]) {
    double *impulse = rigid_fields_impulse(context->particles)[i], contact[6];
    rigid_bodies_contact(context, i, contact);
    for (int d = 0; d < 6; d++)
        impulse[d] += time * (contact[d] - push[d]);
}

void rigid_motion_gather(const struct physics_context *context) {
    const struct particles *p = context->particles;
    const struct bodies *bodies = bodies_of(context->set);
    const double dt = grain_due(context) ? 0.5 * context->clock->dt : context->clock->dt, none[6] = {0};
    struct kind_span span = rigid_bodies_span(context);
    if (bodies != NULL)
        bodies_motion_gather(bodies->links, context);
    for (size_t i = span.first; i < span.end; i++) {
        if (rigid_bodies_member(p, i))
            continue;
        motion_begin(context, i);
        if (!grains_solved(context))
            momentum_add(context, i, dt, none);
    }
}

bool rigid_motion_solved(const struct physics_context *context) {
    return fluid_rigid(context->options) && grains_solved(context);
}

void rigid_motion_gather_solved(const struct physics_context *context) {
    const struct particles *p = context->particles;
    const double dt = context->clock->step == 1 ? 0.5 * context->clock->dt : context->clock->dt;
    struct kind_span span = rigid_bodies_span(context);
    for (size_t i = span.first; i < span.end; i++)
        if (!rigid_bodies_member(p, i))
            momentum_add(context, i, dt, fluid_push(p)[i]);
}

/* The time from the velocities that grains store to those that the fluid finds: none where a solver finds the forces of contacts for these
 * velocities. */
static double half_of(const struct physics_context *context) {
    return grains_solved(context) ? 0 : 0.5 * context->clock->dt;
}

/* What is added to force and torque of contacts on i. */
static void push_of(const struct physics_context *context, size_t i, const struct rigid_inertia *inertia,
                    double push[6]) {
    const double *held = rigid_fields_held(context->particles)[i];
    for (int d = 0; d < 3; d++) {
        push[d] = d < context->box->dimension ? held[d] - inertia->displaced * context->scene->gravity[d] : 0;
        push[3 + d] = inertia->turns ? held[3 + d] : 0;
    }
}

/* Velocity and spin at half a step of the grains before those that the fluid found. */
static void set(const struct physics_context *context, size_t i, const double contact[6], double jump[6]) {
    const double *found = rigid_fields_motion(context->particles)[i], half = half_of(context);
    const struct rigid_inertia inertia = inertia_of(context, i);
    double push[6], motion[6], before[6], torque[3];
    push_of(context, i, &inertia, push);
    rigid_bodies_motion(context, i, before);
    for (int d = 0; d < 3; d++)
        torque[d] = contact[3 + d] + push[3 + d];
    rigid_bodies_turn(context, i, torque, half, motion + 3);
    for (int d = 0; d < 3; d++) {
        motion[d] = found[d] - half * ((contact[d] + push[d]) / inertia.mass + context->scene->gravity[d]);
        motion[3 + d] = found[3 + d] - motion[3 + d];
    }
    rigid_bodies_set(context, i, motion);
    rigid_bodies_motion(context, i, motion);
    for (int d = 0; d < 6; d++)
        jump[d] = motion[d] - before[d];
}

/* The load of a step of the fluid goes into that of the grain's own steps. */
static void load_hold(const struct particles *p, size_t i) {
    const double *load = fluid_load(p)[i];
    double *held = rigid_fields_held(p)[i];
    for (int d = 0; d < 6; d++)
        held[d] += RIGID_LOAD * (load[d] - held[d]);
}

void rigid_motion_set(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    const struct particles *p = context->particles;
    struct kind_span span = rigid_bodies_span(context);
    const double half = half_of(context);
    memory_free(fluid->jump);
    fluid->jump = memory_allocate_zero(p->owned, sizeof *fluid->jump, "grains in a fluid");
    for (size_t i = span.first; i < span.end; i++) {
        double *impulse = rigid_fields_impulse(p)[i], contact[6];
        if (rigid_bodies_member(p, i))
            continue;
        rigid_bodies_contact(context, i, contact);
        load_hold(p, i);
        if (inertia_of(context, i).moves)
            set(context, i, contact, fluid->jump[i]);
        for (int d = 0; d < 6; d++) /* the half of the next step of the fluid */
            impulse[d] = half * contact[d];
    }
}

/* The work of a push, as that of grain_coupling.h, and of the jump of velocity and spin. */
static double work_of(const struct physics_context *context, size_t i, const struct rigid_inertia *inertia,
                      const double push[6]) {
    const struct fluid *fluid = context->self;
    const double none[6] = {0}, *jump = fluid->jump != NULL ? fluid->jump[i] : none,
                 *last = fluid_push(context->particles)[i], half = 0.5 * context->clock->dt;
    double motion[6], contact[6], change[6], all[6], sum = 0;
    rigid_bodies_motion(context, i, motion);
    rigid_bodies_contact(context, i, contact);
    rigid_grains_spin(inertia->own, jump + 3, change + 3);
    for (int d = 0; d < 6; d++)
        all[d] = contact[d] + push[d];
    for (int d = 0; d < 3; d++) {
        change[d] = inertia->mass * jump[d];
        all[d] += inertia->mass * context->scene->gravity[d];
    }
    for (int d = 0; d < 6; d++)
        sum += half * (push[d] + (context->clock->step > 0 ? last[d] : 0)) * (motion[d] - jump[d]) +
               change[d] * (motion[d] - 0.5 * jump[d]) + half * jump[d] * all[d];
    return sum;
}

static void push_add(const struct physics_context *context, size_t i, const struct rigid_inertia *inertia,
                     const double push[6]) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    double *last = fluid_push(p)[i], *force = p->force + i * (size_t)p->force_stride;
    fluid->work += work_of(context, i, inertia, push);
    memcpy(last, push, sizeof fluid_push(p)[i]);
    for (int d = 0; d < 3; d++) {
        force[d] += push[d];
        if (inertia->turns)
            force[4 + d] += push[3 + d];
    }
}

void rigid_motion_apply(const struct physics_context *context) {
    const struct particles *p = context->particles;
    struct kind_span span = rigid_bodies_span(context);
    for (size_t i = span.first; i < span.end; i++) {
        const struct rigid_inertia inertia = inertia_of(context, i);
        double push[6];
        if (rigid_bodies_member(p, i) || !inertia.moves)
            continue;
        push_of(context, i, &inertia, push);
        push_add(context, i, &inertia, push);
    }
    grain_jumped(context->self);
}
