/* SPDX-License-Identifier: BSD-3-Clause */
/* The load of the fluid on grains, and their motion under it. Read couple.h first. */
#include "fluid/couple.h"
#include "contact/spin.h"
#include "fluid/drag.h"
#include "fluid/dust.h"
#include "fluid/fields.h"
#include "fluid/state.h"
#include "particles/fields.h"
#include "particles/kinds.h"
#include <math.h>
#include <string.h>

bool couple_free(const struct fluid_options *options) {
    return options->grains.motion == FLUID_GRAINS_FREE;
}

bool couple_suits(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    if (couple_free(options) && options->motion.name != FLUID_LAGRANGIAN)
        return scene_fail(
            context->scene, error, "fluid.grains",
            "free grains need particles that follow the fluid, motion: lagrangian; allowed with "
            "others: given");
    if (options->grains.every > 1 && !couple_free(options) && !dust_any(options))
        return scene_fail(context->scene, error, "fluid.grains.every",
                          "the fluid moves no grains; allowed with others: 1");
    return dust_suits(context, error);
}

uint64_t couple_every(const struct physics_context *context) {
    const struct fluid_options *options = context->options;
    return couple_free(options) || dust_any(options) ? (uint64_t)options->grains.every : 1;
}

bool couple_due(const struct physics_context *context) {
    return context->clock->step % couple_every(context) == 0;
}

double couple_dt(const struct physics_context *context) {
    return (double)couple_every(context) * context->clock->dt;
}

static bool is_free(const struct physics_context *context, const uint8_t *kind, size_t i) {
    const struct particle_state *state = &context->particles->state[i];
    return kind[i] == KIND_GRAIN && state->inverse_mass > 0 && !dust_is(context->options, state->radius);
}

/* Adds the force and the torque of each foot to its grain, which may be a copy. */
static void feet_add(const struct fluid *fluid, struct particles *p) {
    const struct weights *weights = &fluid->weights;
    double(*load)[6] = fluid_load(p);
    for (size_t k = 0; k < weights->foot_start[weights->rows]; k++) {
        size_t i = fluid->forces.grain[k];
        const struct forces_part *part = &fluid->forces.part[k];
        double force[3], lever[3];
        if (i == SIZE_MAX)
            continue;
        for (int d = 0; d < 3; d++) {
            force[d] = part->viscous[d] + part->pressure[d];
            lever[d] = p->state[i].radius * weights->foot[k].normal[d];
            load[i][d] += force[d];
        }
        for (int d = 0; d < 3; d++)
            load[i][3 + d] +=
                lever[(d + 1) % 3] * force[(d + 2) % 3] - lever[(d + 2) % 3] * force[(d + 1) % 3];
    }
}

/* The volume that a grain displaces, in two dimensions an area. */
static double displaced(const struct physics_context *context, double radius) {
    return context->box->dimension == 2 ? M_PI * radius * radius
                                        : 4.0 / 3.0 * M_PI * radius * radius * radius;
}

/* The mean rate of change of a vector since the last step of the fluid: past[0..2] is the vector then, past[3..5] the rate. */
static void past_take(double past[6], const double now[3], bool first, double dt) {
    for (int d = 0; d < 3; d++) {
        past[3 + d] = first ? 0 : (now[d] - past[d]) / dt;
        past[d] = now[d];
    }
}

void couple_load(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    const uint8_t *kind = kinds_of(p);
    double(*load)[6] = fluid_load(p), (*past)[12] = fluid_grain_past(p), (*spin)[4] = spin_of(p);
    bool first = fluid->past.steps <= 1;
    drag_look(&fluid->forces, context, &fluid->flow, fluid->options->viscosity);
    memset(load, 0, (p->owned + p->ghosts) * sizeof *load);
    feet_add(fluid, p);
    if (context->ghosts) {
        struct field_list list = fields_one(fluid_load_handle(p));
        ghosts_sum(context->ghosts, p, &list);
    }
    for (size_t i = 0; i < p->owned; i++) {
        if (!is_free(context, kind, i))
            continue;
        past_take(past[i], p->state[i].v, first, couple_dt(context));
        if (spin != NULL)
            past_take(past[i] + 6, spin[i], first, couple_dt(context));
    }
}

/* The way of diffusion in a step of the fluid, squared. */
static double diffused(const struct physics_context *context) {
    const struct fluid_options *options = context->options;
    return options->viscosity / options->density * couple_dt(context);
}

/* The force on grain i beside that of its contacts, as load, buoyancy and virtual mass want it. */
static void push_of(const struct physics_context *context, size_t i, const double contact[3],
                    double push[3]) {
    const struct fluid *fluid = context->self;
    const struct fluid_options *options = fluid->options;
    const struct particle_state *state = &context->particles->state[i];
    const double *load = fluid_load(context->particles)[i], *past = fluid_grain_past(context->particles)[i];
    const double *gravity = context->motion->gravity, wide = 2 * state->radius;
    double volume = displaced(context, state->radius), mass = 1 / state->inverse_mass;
    double virtual = options->density * volume *
                     (options->grains.virtual_mass +
                      diffused(context) * (18 / (wide * wide) + 4 / (wide * options->spacing)));
    for (int d = 0; d < 3; d++) {
        double own = load[d] + volume * (fluid->drive.force[d] - options->density * gravity[d]);
        double force = own + contact[d] + mass * gravity[d];
        double acceleration = (force + virtual * past[3 + d]) / (mass + virtual);
        push[d] = d < context->box->dimension ? mass * (acceleration - gravity[d]) - contact[d] : 0;
    }
}

/* The same for the torque on a grain, by a virtual moment of inertia. */
static void twist_of(const struct physics_context *context, size_t i, const double contact[3],
                     double twist[3]) {
    const struct fluid_options *options = context->options;
    const struct particle_state *state = &context->particles->state[i];
    const double *load = fluid_load(context->particles)[i], *past = fluid_grain_past(context->particles)[i];
    double r2 = state->radius * state->radius, inertia = 0.4 * r2 / state->inverse_mass;
    double virtual = options->density * displaced(context, state->radius) *
                     (0.25 * options->grains.virtual_mass * r2 + 6 * diffused(context));
    for (int d = 0; d < 3; d++)
        twist[d] =
            inertia * (load[3 + d] + contact[d] + virtual * past[9 + d]) / (inertia + virtual) - contact[d];
}

/* The work of a force is the mean of its powers at the velocities of half a step before and after: the first half is counted
 * now, the second one when the next force is known. That of the torque is counted at once. */
void couple_apply(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    const uint8_t *kind = kinds_of(p);
    double(*last)[3] = fluid_push(p), (*spin)[4] = spin_of(p), half = 0.5 * context->clock->dt;
    for (size_t i = 0; i < p->owned; i++) {
        double push[3], twist[3] = {0}, *force = p->force + i * (size_t)p->force_stride;
        if (!is_free(context, kind, i))
            continue;
        push_of(context, i, force, push);
        if (spin)
            twist_of(context, i, force + 4, twist);
        for (int d = 0; d < 3; d++) {
            fluid->work += half * (push[d] + (context->clock->step > 0 ? last[i][d] : 0)) * p->state[i].v[d];
            last[i][d] = push[d];
            force[d] += push[d];
            if (spin) {
                force[4 + d] += twist[d];
                fluid->work += 2 * half * twist[d] * spin[i][d];
            }
        }
    }
}
