/* SPDX-License-Identifier: BSD-3-Clause */
/* Velocities at grains that the fluid does not resolve, and their forces on it. Read dust.h first. */
#include "fluid/dust.h"
#include "core/memory.h"
#include "drag/carrier.h"
#include "fluid/fields.h"
#include "fluid/state.h"
#include "particles/kinds.h"
#include <math.h>
#include <string.h>

#define OF_DUST .type = FIELD_DOUBLE, .needed_for = "fluid.grains.unresolved"
static const struct field push = {.name = "fluid_given",
                                  .components = 4,
                                  .kinds = 1u << KIND_FLUID,
                                  OF_DUST,
                                  .help = "the same, of a fluid particle on the grains around it"},
                          given_before = {.name = "fluid_given_before",
                                          .components = 3,
                                          .use = FIELD_TRAVELS,
                                          .unit = "N",
                                          .kinds = 1u << KIND_FLUID,
                                          OF_DUST,
                                          .help = "that force in the step before"},
                          impulse = {
                              .name = "fluid_impulse",
                              .components = 3,
                              .use = FIELD_TRAVELS,
                              .unit = "N s",
                              .kinds = 1u << KIND_FLUID,
                              OF_DUST,
                              .help =
                                  "momentum that a fluid particle has to lose in the next step of the fluid"};

bool dust_any(const struct fluid_options *options) {
    return !isnan(options->grains.unresolved);
}

bool dust_is(const struct fluid_options *options, double radius) {
    return radius <= options->grains.unresolved;
}

bool dust_suits(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    static const char key[] = "fluid.grains.unresolved";
    if (!dust_any(options))
        return true;
    if (!context->scene->physics_given[PHYSICS_drag])
        return scene_fail(context->scene, error, key,
                          "the section `drag` is missing, whose law moves such grains");
    if (options->time != FLUID_TRANSIENT || options->electrolytes > 0)
        return scene_fail(context->scene, error, key,
                          "a fluid loses momentum to grains in time alone, and without an electrolyte; "
                          "allowed: time: transient");
    return true;
}

void dust_fields_add(struct particles *particles) {
    carrier_fields_add(particles);
    fields_register(particles, &push);
    fields_register(particles, &given_before);
    fields_register(particles, &impulse);
}

bool dust_needed(const struct physics_context *context) {
    return dust_any(context->options);
}

/* W of an entry of the pairs of grain i, whose particle becomes *j; 0 if that is none of the fluid. */
static double share_of(const struct physics_context *context, size_t i, size_t entry, size_t *j) {
    const struct fluid *fluid = context->self;
    const struct particle_state *state = context->particles->state;
    uint32_t partner = fluid->pairs.partner[entry];
    const double *shift = context->list[0]->shift[pair_image(partner)];
    double square = 0;
    *j = pair_partner(partner);
    if (kinds_of(context->particles)[*j] != KIND_FLUID)
        return 0;
    for (int d = 0; d < context->box->dimension; d++) {
        double to = state[*j].x[d] - state[i].x[d] + shift[d];
        square += to * to;
    }
    return kernel_value(&fluid->weigh.kernel, sqrt(square));
}

/* The sum of W around grain i. */
static double shares_of(const struct physics_context *context, size_t i) {
    const struct pair_rows *pairs = &((const struct fluid *)context->self)->pairs;
    double sum = 0;
    size_t j;
    for (size_t e = pairs->start[i]; e < pairs->start[i + 1]; e++)
        sum += share_of(context, i, e, &j);
    return sum;
}

static bool is_dust(const struct physics_context *context, size_t i) {
    const struct particles *p = context->particles;
    return kinds_of(p)[i] == KIND_GRAIN && dust_is(context->options, p->state[i].radius);
}

static void look_at(const struct physics_context *context, size_t i, double sum, double u[3]) {
    const struct pair_rows *pairs = &((const struct fluid *)context->self)->pairs;
    size_t j;
    for (int d = 0; d < 3; d++)
        u[d] = 0;
    for (size_t e = pairs->start[i]; e < pairs->start[i + 1]; e++) {
        double share = share_of(context, i, e, &j) / sum;
        for (int d = 0; d < context->box->dimension && share > 0; d++)
            u[d] += share * context->particles->state[j].v[d];
    }
}

void dust_look(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    const struct particles *p = context->particles;
    double(*u)[3] = carrier_seen(p);
    size_t lost = SIZE_MAX;
#pragma omp parallel for schedule(static) reduction(min : lost)
    for (size_t i = 0; i < p->owned; i++) {
        if (!is_dust(context, i))
            continue;
        double sum = shares_of(context, i);
        if (sum > 0)
            look_at(context, i, sum, u[i]);
        else
            lost = i < lost ? i : lost;
    }
    int64_t worst = lost == SIZE_MAX ? -1 : p->id[lost];
    comm_max_int(context->comm, &worst, 1);
    if (worst >= 0)
        error_set(&fluid->error, ERROR_PHYSICS,
                  "fluid.grains.unresolved: grain %lld has no fluid around it in step %llu, t = %.9g",
                  (long long)worst, (unsigned long long)context->clock->step, context->clock->time);
}

/* The forces of all grains on the fluid particles of this rank. */
static void spread(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    double(*taken)[4] = carrier_force(p), (*given)[4] = fields_values(p, &push);
    size_t j;
    memset(given, 0, (p->owned + p->ghosts) * sizeof *given);
    for (size_t i = 0; i < p->owned; i++) {
        if (!is_dust(context, i))
            continue;
        double sum = shares_of(context, i);
        for (size_t e = fluid->pairs.start[i]; sum > 0 && e < fluid->pairs.start[i + 1]; e++) {
            double share = share_of(context, i, e, &j) / sum;
            for (int d = 0; d < 4 && share > 0; d++)
                given[j][d] += share * taken[i][d];
        }
    }
    if (context->ghosts) {
        struct field_list list = fields_one(fields_handle(p, &push));
        ghosts_sum(context->ghosts, p, &list);
    }
}

/* Stops an exchange that would turn the slip around within a step of the fluid. */
static void check(const struct physics_context *context, double worst, double dt) {
    struct fluid *fluid = context->self;
    double rate = worst / fluid->options->density;
    comm_max(context->comm, &rate, 1);
    if (rate * dt > 1)
        error_set(&fluid->error, ERROR_PHYSICS,
                  "fluid.grains.unresolved: grains take the momentum of the fluid between them in %.4g, less "
                  "than a step "
                  "of the fluid, %.4g (step %llu, t = %.9g): shorten step.dt, or lower fluid.grains.every",
                  1 / rate, dt, (unsigned long long)context->clock->step, context->clock->time);
}

void dust_give(const struct physics_context *context, double dt) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    const struct weights *weights = &fluid->weights;
    double(*before)[3] = fields_values(p, &given_before), (*sum)[3] = fields_values(p, &impulse);
    double half = 0.5 * context->clock->dt, worst = 0;
    spread(context);
    double(*now)[4] = fields_values(p, &push);
    for (size_t row = 0; row < weights->rows; row++) {
        size_t i = weights->first + row;
        for (int d = 0; d < 3; d++) {
            sum[i][d] -= context->clock->step > 0 ? half * (before[i][d] + now[i][d]) : 0;
            before[i][d] = now[i][d];
        }
        worst = fmax(worst, now[i][3] / weights->volume[row]);
    }
    check(context, worst, dt);
}

void dust_act(const struct physics_context *context, double dt) {
    struct fluid *fluid = context->self;
    const struct weights *weights = &fluid->weights;
    double(*sum)[3] = fields_values(context->particles, &impulse);
    fluid->given = memory_resize(fluid->given, weights->rows, sizeof *fluid->given, "forces of grains");
    for (size_t row = 0; row < weights->rows; row++)
        for (int d = 0; d < 3; d++) {
            fluid->given[row][d] = sum[weights->first + row][d] / (dt * weights->volume[row]);
            sum[weights->first + row][d] = 0;
        }
    fluid->flow.body = (const double(*)[3])fluid->given;
}
