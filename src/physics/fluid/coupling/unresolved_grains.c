/* SPDX-License-Identifier: BSD-3-Clause */
/* What grains that the fluid does not resolve see of it, and what they give it. Read unresolved_grains.h first. */
#include "physics/fluid/coupling/unresolved_grains.h"
#include "base/memory.h"
#include "physics/drag/carrier.h"
#include "physics/fluid/coupling/unresolved_shares.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/fluid_state.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <string.h>

/* The largest part of the room around a particle of the fluid that grains may take. */
static const double solid_most = 0.95;

/* What grains give to a fluid particle, sums of shares: momentum, velocity times volume, volume, force over slip, and that times w at the grain. */
enum { IMPULSE, FLUX = IMPULSE + 3, SOLID = FLUX + 3, DRAG, DRAWN, SUMS = DRAWN + 3 };

/* What a fluid particle shows to grains: gradients of the pressure and of its change, and the share of the room that grains take. */
enum { CHANGE = 3, TAKEN = 6, SLOPES };

#define OF_DUST .type = FIELD_DOUBLE, .needed_for = "fluid.grains.unresolved"
static const struct field given = {.name = "fluid_given",
                                   .components = SUMS,
                                   .kinds = 1u << KIND_FLUID,
                                   OF_DUST,
                                   .help = "what the grains around a fluid particle give it"},
                          slopes = {.name = "fluid_slopes",
                                    .components = SLOPES,
                                    .kinds = 1u << KIND_FLUID,
                                    OF_DUST,
                                    .help = "gradients of the pressure and of its change in a step; share of "
                                            "the room that grains take"},
                          solids = {.name = "fluid_solids",
                                    .components = 4,
                                    .use = FIELD_TRAVELS | FIELD_OUTPUT | FIELD_ASKED,
                                    .kinds = 1u << KIND_FLUID,
                                    OF_DUST,
                                    .help =
                                        "of grains that a fluid does not resolve: volume flow, m s-1, and "
                                        "share of the room"},
                          carried = {.name = "fluid_carried",
                                     .components = 6,
                                     .kinds = 1u << KIND_FLUID,
                                     OF_DUST,
                                     .help = "volume flow and velocity of the fluid between grains"},
                          taken_before = {.name = "fluid_taken_before",
                                          .components = 3,
                                          .use = FIELD_TRAVELS,
                                          .unit = "N",
                                          .kinds = 1u << KIND_GRAIN,
                                          OF_DUST,
                                          .help = "force of the fluid on such a grain in the step before"},
                          impulse = {
                              .name = "fluid_impulse",
                              .components = 3,
                              .use = FIELD_TRAVELS,
                              .unit = "N s",
                              .kinds = 1u << KIND_GRAIN,
                              OF_DUST,
                              .help = "momentum that the fluid has to lose to such a grain in its next step"};

bool unresolved_any(const struct fluid_options *options) {
    return !isnan(options->grains.unresolved);
}

bool unresolved_is(const struct fluid_options *options, double radius) {
    return radius <= options->grains.unresolved;
}

bool unresolved_averaged(const struct fluid_options *options) {
    return unresolved_any(options) && options->motion.name == FLUID_FIXED;
}

bool unresolved_suits(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    static const char key[] = "fluid.grains.unresolved";
    if (!unresolved_any(options))
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

void unresolved_fields_add(const struct fluid_options *options, struct particles *particles) {
    carrier_fields_add(particles);
    fields_register(particles, &given);
    fields_register(particles, &taken_before);
    fields_register(particles, &impulse);
    if (!unresolved_averaged(options))
        return;
    fields_register(particles, &slopes);
    fields_register(particles, &solids);
    fields_register(particles, &carried);
    fluid_fields_mobility(particles);
}

void unresolved_flow(const struct particles *particles, size_t i, double flow[3]) {
    double(*solid)[4] = fields_values(particles, &solids);
    for (int d = 0; d < 3; d++)
        flow[d] = particles->state[i].v[d] - (solid != NULL ? solid[i][d] : 0);
}

/* The volume of a grain: in two dimensions of a sphere in a unit of depth, or the area of a disc where densities are by area. */
static double room_of(const struct physics_context *context, size_t i) {
    double radius = context->particles->state[i].radius, disc = M_PI * radius * radius;
    return context->box->density == BOX_DENSITY_AREA ? disc : 4.0 / 3.0 * radius * disc;
}

/* The velocity of a grain at the moment of its place; that of the state is half a step older. */
static void velocity_of(const struct physics_context *context, size_t i, double v[3]) {
    const struct particles *p = context->particles;
    const struct particle_state *state = &p->state[i];
    const double *force = p->force + i * (size_t)p->force_stride;
    double half = state->inverse_mass > 0 && context->clock->step > 0 ? 0.5 * context->clock->dt : 0;
    for (int d = 0; d < 3; d++)
        v[d] = d < context->box->dimension
                   ? state->v[d] + half * (force[d] * state->inverse_mass + context->scene->gravity[d])
                   : 0;
}

/* What grain i gives. */
static void parts_of(const struct physics_context *context, size_t i, double factor, const double lost[3],
                     double part[SUMS]) {
    const double volume = room_of(context, i), *seen = ((struct fluid *)context->self)->dust->seen[i];
    double v[3];
    velocity_of(context, i, v);
    for (int d = 0; d < 3; d++) {
        part[IMPULSE + d] = lost[d];
        part[FLUX + d] = volume * v[d];
        part[DRAWN + d] = factor * seen[d];
    }
    part[SOLID] = volume;
    part[DRAG] = factor;
}

/* The sums over the grains of all ranks. */
static void spread(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    double(*sum)[SUMS] = fields_values(p, &given), (*taken)[4] = carrier_force(p),
    (*lost)[3] = fields_values(p, &impulse), part[SUMS];
    memset(sum, 0, (p->owned + p->ghosts) * sizeof *sum);
    for (size_t i = 0; i < p->owned; i++) {
        if (!unresolved_shares_has(context, i))
            continue;
        parts_of(context, i, taken[i][3], lost[i], part);
        for (size_t e = fluid->pairs.start[i]; e < fluid->dust->end[i]; e++)
            for (int k = 0; k < SUMS; k++)
                sum[fluid->dust->of[e]][k] += fluid->dust->share[e] * part[k];
    }
    if (context->ghosts) {
        struct field_list list = fields_one(fields_handle(p, &given));
        ghosts_sum(context->ghosts, p, &list);
    }
}

static void forward(const struct physics_context *context, struct field_list list) {
    if (context->ghosts == NULL)
        return;
    ghosts_forward_begin(context->ghosts, context->particles, &list);
    ghosts_forward_end(context->ghosts, context->particles);
}

/* The gradients of the pressure and of its change, where grains feel them. */
static void slopes_make(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    const struct weights *weights = &fluid->weights;
    struct unresolved *dust = fluid->dust;
    double(*slope)[SLOPES] = fields_values(context->particles, &slopes),
    (*solid)[4] = fields_values(context->particles, &solids);
    dust->slope = memory_resize(dust->slope, weights->rows, sizeof *dust->slope, "grains in a fluid");
    for (int k = 0; k < 2; k++) {
        operators_gradient(weights, k == 0 ? flow_pressure(&fluid->flow) : flow_increment(&fluid->flow),
                           dust->slope);
        for (size_t row = 0; row < weights->rows; row++)
            memcpy(&slope[weights->first + row][CHANGE * k], dust->slope[row], sizeof *dust->slope);
    }
    for (size_t row = 0; row < weights->rows; row++)
        slope[weights->first + row][TAKEN] = solid[weights->first + row][3];
    forward(context, fields_one(fields_handle(context->particles, &slopes)));
}

/* What grain i sees, of the fluid's `slope` (NULL: none is shown); `change` becomes the gradient of the change of the pressure there. */
static void look_at(const struct physics_context *context, size_t i, const double *slope,
                    double seen[CARRIER_SEEN], double change[3]) {
    const struct fluid *fluid = context->self;
    double at[SLOPES] = {0}, volume = slope != NULL ? room_of(context, i) : 0;
    unresolved_shares_mean(fluid, i, flow_velocity(&fluid->flow), 3, seen);
    if (slope != NULL)
        unresolved_shares_mean(fluid, i, (struct operators_values){.value = slope, .stride = SLOPES}, SLOPES,
                               at);
    for (int d = 0; d < 3; d++) {
        seen[CARRIER_PUSH + d] = d < context->box->dimension ? volume * (fluid->drive.force[d] - at[d]) : 0;
        change[d] = at[CHANGE + d];
    }
    seen[CARRIER_SHARE] = 1 - at[TAKEN];
}

/* The momentum of grain i jumps; returns the work. */
static double jump(const struct physics_context *context, size_t i, const double add[3]) {
    struct particle_state *state = &context->particles->state[i];
    double v[3], work = 0;
    velocity_of(context, i, v);
    for (int d = 0; d < context->box->dimension; d++) {
        work += add[d] * (v[d] + 0.5 * add[d] * state->inverse_mass);
        state->v[d] += add[d] * state->inverse_mass;
    }
    return work;
}

void unresolved_look(const struct physics_context *context, double dt) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    bool averaged = unresolved_averaged(context->options);
    double(*taken)[4] = carrier_force(p), (*seen)[CARRIER_SEEN] = carrier_seen(p), work = 0;
    if (averaged)
        slopes_make(context);
    const double *slope = fields_values(p, &slopes);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->owned; i++) {
        double change[3], *before = fluid->dust->seen[i];
        if (!unresolved_shares_has(context, i))
            continue;
        look_at(context, i, slope, seen[i], change);
        for (int d = 0; d < 3; d++) /* becomes the jump */
            before[d] = dt * (taken[i][3] * (seen[i][d] - before[d]) - room_of(context, i) * change[d]);
    }
    for (size_t i = 0; i < p->owned && averaged; i++)
        if (unresolved_shares_has(context, i) && p->state[i].inverse_mass > 0)
            work += jump(context, i, fluid->dust->seen[i]);
    fluid->work += work;
}

/* What the fluid particles have of grains: solids, and the factors of their step. */
static void solids_take(const struct physics_context *context, double dt) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    const struct weights *weights = &fluid->weights;
    double(*sum)[SUMS] = fields_values(p, &given), (*solid)[4] = fields_values(p, &solids),
    *mobility = fluid_mobility(p), density = fluid->options->density;
    for (size_t row = 0; row < weights->rows; row++) {
        size_t i = weights->first + row;
        double volume = weights->volume[row], a = dt * sum[i][DRAG] / (density * volume),
               *u = flow_velocity_of(&fluid->flow, row);
        for (int d = 0; d < 3; d++) {
            double flux = sum[i][FLUX + d] / volume;
            if (dt > 0)
                fluid->dust->body[row][d] +=
                    density * (flux - solid[i][d]) / dt + (sum[i][DRAWN + d] - sum[i][DRAG] * u[d]) / volume;
            solid[i][d] = flux;
        }
        solid[i][3] = sum[i][SOLID] / volume;
        mobility[i] = (1 - solid[i][3]) / (1 + a);
        if (dt > 0)
            fluid->dust->resist[row] = a;
    }
    forward(context, (struct field_list){
                         .count = 2, .field = {fields_handle(p, &solids), fluid_handle(p, FLOW_MOBILITY)}});
}

/* The volume flow of the fluid alone, and its velocity, of the state that a step begins with. */
static void carried_make(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    const struct particles *p = context->particles;
    const uint8_t *kind = kinds_of(p);
    double(*solid)[4] = fields_values(p, &solids), (*pair)[2][3] = fields_values(p, &carried);
    forward(context, fields_one(fields_handle(p, &solids)));
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->owned + p->ghosts; i++)
        for (int d = 0; d < 3 && kind[i] == KIND_FLUID; d++) {
            pair[i][0][d] = p->state[i].v[d] - solid[i][d];
            pair[i][1][d] = pair[i][0][d] / (1 - solid[i][3]);
        }
    fluid->flow.carried = (const double(*)[2][3])pair;
}

/* Stops grains that leave the fluid no room, or that would turn the slip around within its next step. */
static void check(const struct physics_context *context, double dt) {
    struct fluid *fluid = context->self;
    const struct weights *weights = &fluid->weights;
    double(*sum)[SUMS] = fields_values(context->particles, &given), worst[2] = {0};
    for (size_t row = 0; row < weights->rows; row++) {
        const double *own = sum[weights->first + row];
        worst[0] = fmax(worst[0], own[DRAG] / (weights->volume[row] * fluid->options->density));
        worst[1] = fmax(worst[1], own[SOLID] / weights->volume[row]);
    }
    comm_max(context->comm, worst, 2);
    bool averaged = unresolved_averaged(context->options);
    if (!averaged && worst[0] * dt > 1)
        error_set(&fluid->error, ERROR_PHYSICS,
                  "fluid.grains.unresolved: grains take the momentum of the fluid between them in %.4g, less "
                  "than a step "
                  "of the fluid, %.4g (step %llu, t = %.9g): shorten step.dt, or lower fluid.grains.every",
                  1 / worst[0], dt, (unsigned long long)context->clock->step, context->clock->time);
    if (averaged && worst[1] > solid_most)
        error_set(
            &fluid->error, ERROR_PHYSICS,
            "fluid.grains.unresolved: grains take %.3g of the room around a particle of the fluid, "
            "which is more than %g (step %llu, t = %.9g): a longer fluid.spacing averages over more grains",
            worst[1], solid_most, (unsigned long long)context->clock->step, context->clock->time);
}

void unresolved_begin(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    const struct particles *p = context->particles;
    double change[3], (*seen)[CARRIER_SEEN] = carrier_seen(p);
    unresolved_shares_make(context);
    if (fluid->error.kind != ERROR_NONE)
        return;
    spread(context);
    if (unresolved_averaged(context->options)) {
        solids_take(context, 0);
        slopes_make(context);
    }
    for (size_t i = 0; i < p->owned; i++)
        if (unresolved_shares_has(context, i))
            look_at(context, i, fields_values(p, &slopes), seen[i], change);
}

void unresolved_give(const struct physics_context *context) {
    struct particles *p = context->particles;
    double(*before)[3] = fields_values(p, &taken_before), (*lost)[3] = fields_values(p, &impulse),
    (*taken)[4] = carrier_force(p), half = 0.5 * context->clock->dt;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->owned; i++)
        for (int d = 0; d < 3 && unresolved_shares_has(context, i); d++) {
            lost[i][d] += context->clock->step > 0 ? half * (before[i][d] + taken[i][d]) : 0;
            before[i][d] = taken[i][d];
        }
}

void unresolved_act(const struct physics_context *context, double dt) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    const struct weights *weights = &fluid->weights;
    bool averaged = unresolved_averaged(context->options);
    unresolved_shares_make(context);
    if (fluid->error.kind != ERROR_NONE)
        return;
    struct unresolved *dust = fluid->dust;
    dust->body = memory_resize(dust->body, weights->rows, sizeof *dust->body, "grains in a fluid");
    dust->resist = memory_resize(dust->resist, weights->rows, sizeof *dust->resist, "grains in a fluid");
    spread(context);
    check(context, dt);
    double(*sum)[SUMS] = fields_values(p, &given), (*lost)[3] = fields_values(p, &impulse);
    for (size_t row = 0; row < weights->rows; row++)
        for (int d = 0; d < 3; d++)
            dust->body[row][d] = -sum[weights->first + row][IMPULSE + d] / (dt * weights->volume[row]);
    if (averaged) {
        carried_make(context);
        solids_take(context, dt);
    }
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->owned; i++)
        if (unresolved_shares_has(context, i))
            memset(lost[i], 0, sizeof lost[i]);
    fluid->flow.body = (const double(*)[3])dust->body;
    fluid->flow.resist = averaged ? dust->resist : NULL;
    fluid->flow.mobility = averaged ? fluid_mobility(p) : NULL;
}
