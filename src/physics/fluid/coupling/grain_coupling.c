/* SPDX-License-Identifier: BSD-3-Clause */
/* The load of the fluid on grains, and their motion under it. Read grain_coupling.h first. */
#include "physics/fluid/coupling/grain_coupling.h"
#include "kernel/particles/spin.h"
#include "base/memory.h"
#include "physics/fluid/coupling/surface_loads.h"
#include "physics/fluid/coupling/unresolved_grains.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/fluid_state.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

bool grain_free(const struct fluid_options *options) {
    return options->grains.motion == FLUID_GRAINS_FREE;
}

bool grain_passes(const struct fluid_options *options) {
    return fluid_carries(options) || fluid_rigid(options);
}

bool grain_suits(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    if (fluid_rigid(options))
        return true; /* rigid_suits.h */
    if (grain_free(options) && options->motion.name != FLUID_LAGRANGIAN)
        return scene_fail(context->scene, error, "fluid.grains",
                          "free grains need coupling: rigid, or particles that follow the fluid, motion: "
                          "lagrangian; allowed with "
                          "others: given");
    if (options->grains.every > 1 && !grain_free(options) && !unresolved_any(options))
        return scene_fail(context->scene, error, "fluid.grains.every",
                          "the fluid moves no grains; allowed with others: 1");
    return unresolved_suits(context, error);
}

static bool resolved(const struct physics_context *context, size_t i) {
    const struct particles *p = context->particles;
    return kinds_of(p)[i] == KIND_GRAIN && !unresolved_is(context->options, p->state[i].radius);
}

/* True if the grains of a group turn at most, each about its own centre: to a fluid they stay where they are. */
static bool group_stays(const struct scene_group *group) {
    return group->motion == SCENE_FROZEN || (group->motion == SCENE_MOVING && group->velocity[0] == 0 &&
                                             group->velocity[1] == 0 && group->velocity[2] == 0);
}

static bool group_turns(const struct scene_group *group) {
    return group->motion == SCENE_MOVING &&
           (group->omega[0] != 0 || group->omega[1] != 0 || group->omega[2] != 0);
}

/* False, with an error, if a grain moves, or is to turn in a scene in which grains do not. */
static bool motion_suits(const struct physics_context *context, size_t k, struct error *error) {
    const struct particles *p = context->particles;
    const struct scene *scene = context->scene;
    int number = groups_of(p) ? groups_of(p)[k] : 0;
    const struct scene_group *group = &scene->group[number];
    char key[64];
    if (group_turns(group) && spin_of(p) == NULL) {
        snprintf(key, sizeof key, "groups[%d].omega", number - 1);
        return scene_fail(scene, error, key,
                          "group '%s' has a spin, but grains turn only with a contact law that has friction",
                          group->name);
    }
    bool given = group->motion == SCENE_MOVING && grain_passes(context->options);
    if (grain_free(context->options) || group_stays(group) || given || !resolved(context, k))
        return true;
    if (number == 0)
        return scene_fail(scene, error, "particles",
                          "grain %lld moves freely; allowed beside `fluid`: grains of groups with "
                          "motion: frozen, or free "
                          "grains with fluid.grains: free",
                          (long long)p->id[k]);
    snprintf(key, sizeof key, "groups[%d].%s", number - 1,
             group->motion == SCENE_FREE ? "motion" : "velocity");
    return scene_fail(
        scene, error, key,
        "group '%s' moves; allowed beside `fluid`: groups that are frozen or only spin, and with "
        "fluid.motion: lagrangian groups whose motion is given",
        group->name);
}

static const char come[] = "grains cannot be inserted into a fluid; not built yet";
static const char stay[] =
    "would take grains out of the fluid that resolves them; allowed beside resolved grains: ";

static bool any_resolved(const struct physics_context *context) {
    bool any = false;
    for (size_t k = 0; !any && k < context->particles->owned; k++)
        any = resolved(context, k);
    return any;
}

bool grain_admit(const struct physics_context *context, const struct physics_grain *grain,
                 struct error *error) {
    if (grain)
        return error_set(error, ERROR_USER, "%s", come);
    if (any_resolved(context))
        error_set(error, ERROR_USER, "a deletion %snone", stay);
    return comm_agree(context->comm, error);
}

/* Grains may not come, and may not go with a part of the surface of the fluid. */
static bool numbers_suit(const struct physics_context *context, struct error *error) {
    const struct scene *scene = context->scene;
    const struct box *box = context->box;
    const bool any = any_resolved(context);
    if (scene->insertions > 0)
        return scene_fail(scene, error, "insertions", "%s", come);
    if (any && scene->deletions > 0)
        return scene_fail(scene, error, "deletions", "%snone", stay);
    for (int d = 0; any && d < box->dimension; d++)
        if (!box->periodic[d] && (box->leave[d][0] == BOX_DELETE || box->leave[d][1] == BOX_DELETE))
            return scene_fail(scene, error, "box.leave", "delete %skeep, error", stay);
    return true;
}

/* Each rank looks at its own grains, whether their source or a selection put them into a group. */
static bool grains_suit(const struct physics_context *context, struct error *error) {
    const struct particles *p = context->particles;
    for (size_t k = 0; k < p->owned; k++)
        if (kinds_of(p)[k] == KIND_GRAIN && !motion_suits(context, k, error))
            return false;
    return numbers_suit(context, error);
}

bool grain_grains_suit(const struct physics_context *context, struct error *error) {
    bool good = grains_suit(context, error);
    return comm_agree(context->comm, error) && good;
}

uint64_t grain_every(const struct physics_context *context) {
    const struct fluid_options *options = context->options;
    return grain_free(options) || unresolved_any(options) ? (uint64_t)options->grains.every : 1;
}

const char *grain_pockets(const struct fluid_options *options) {
    return grain_free(options) && !fluid_rigid(options)
               ? "; where grains close pockets of fluid between them no step is short enough "
                 "(docs/fluid-limits.md)"
               : "";
}

bool grain_due(const struct physics_context *context) {
    return context->clock->step % grain_every(context) == 0;
}

double grain_dt(const struct physics_context *context) {
    return (double)grain_every(context) * context->clock->dt;
}

bool grain_moves(const struct physics_context *context, size_t i) {
    return context->particles->state[i].inverse_mass > 0 && resolved(context, i);
}

/* Adds the force and the torque of each foot to its grain, which may be a copy. */
static void feet_add(const struct fluid *fluid, struct particles *p) {
    const struct weights *weights = &fluid->weights;
    double(*load)[6] = fluid_load(p);
    for (size_t k = 0; k < weights->foot_start[weights->rows]; k++) {
        size_t i = fluid->forces.grain[k];
        const struct surface_forces_part *part = &fluid->forces.part[k];
        double torque[3], lever[3];
        if (i == SIZE_MAX)
            continue;
        for (int d = 0; d < 3; d++)
            lever[d] = p->state[i].radius * weights->foot[k].normal[d];
        surface_forces_torque(part, lever, torque);
        for (int d = 0; d < 3; d++) {
            load[i][d] += part->viscous[d] + part->pressure[d];
            load[i][3 + d] += torque[d];
        }
    }
}

double grain_displaced(const struct physics_context *context, double radius) {
    return context->box->dimension == 2 ? M_PI * radius * radius
                                        : 4.0 / 3.0 * M_PI * radius * radius * radius;
}

void grain_load(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    double(*load)[6] = fluid_load(p);
    surface_loads_look(&fluid->forces, context, &fluid->flow, fluid->options->viscosity);
    memset(load, 0, (p->owned + p->ghosts) * sizeof *load);
    feet_add(fluid, p);
    if (context->ghosts) {
        struct field_list list = fields_one(fluid_load_handle(p));
        ghosts_sum(context->ghosts, p, &list);
    }
}

void grain_push(const struct physics_context *context, size_t i, double push[3]) {
    const struct fluid *fluid = context->self;
    double volume = grain_displaced(context, context->particles->state[i].radius);
    for (int d = 0; d < 3; d++)
        push[d] =
            d < context->box->dimension
                ? volume * (fluid->drive.force[d] - fluid->options->density * context->scene->gravity[d])
                : 0;
}

/* The work of a force is the mean of its powers at the velocities of half a step before and after: the first half is counted
 * now, the second one when the next force is known. That of the torque is counted at once, and that of a jump of the velocity as
 * the change of the energy of the full step. */
static double work_of(const struct physics_context *context, size_t i, const double push[3],
                      const double last[3], const double torque[3]) {
    const struct fluid *fluid = context->self;
    const struct particles *p = context->particles;
    const struct particle_state *state = &p->state[i];
    const double *force = p->force + i * (size_t)p->force_stride, none[6] = {0},
                 *jump = fluid->jump != NULL ? fluid->jump[i] : none;
    double(*spin)[4] = spin_of(p), half = 0.5 * context->clock->dt, mass = 1 / state->inverse_mass, sum = 0,
    inertia = 0.4 * mass * state->radius * state->radius;
    for (int d = 0; d < 3; d++) {
        double before = state->v[d] - jump[d], all = force[d] + push[d] + mass * context->scene->gravity[d];
        sum += half * (push[d] + (context->clock->step > 0 ? last[d] : 0)) * before +
               jump[d] * (mass * (before + 0.5 * jump[d]) + half * all);
        if (spin != NULL)
            sum += 2 * half * torque[d] * (spin[i][d] - jump[3 + d]) +
                   inertia * jump[3 + d] * (spin[i][d] - 0.5 * jump[3 + d]);
    }
    return sum;
}

double grain_added(const struct physics_context *context, double radius) {
    const struct fluid_options *options = context->options;
    return (context->box->dimension == 2 ? 1 : 0.5) * options->density * grain_displaced(context, radius);
}

/* The load before the first step of the fluid: that of the added mass of a grain alone, on which `force` acts besides weight and push. */
static void load_guess(const struct physics_context *context, size_t i, const double force[3],
                       const double push[3]) {
    const struct particle_state *state = &context->particles->state[i];
    double added = grain_added(context, state->radius), mass = 1 / state->inverse_mass,
           *load = fluid_load(context->particles)[i];
    memset(load, 0, sizeof fluid_load(context->particles)[i]);
    for (int d = 0; d < context->box->dimension; d++)
        load[d] = -added * (force[d] + mass * context->scene->gravity[d] + push[d]) / (mass + added);
}

void grain_add(const struct physics_context *context, size_t i, const double push[3],
               const double torque[3]) {
    struct fluid *fluid = context->self;
    struct particles *p = context->particles;
    double *last = fluid_push(p)[i], *force = p->force + i * (size_t)p->force_stride;
    fluid->work += work_of(context, i, push, last, torque);
    for (int d = 0; d < 3; d++) {
        last[d] = push[d];
        force[d] += push[d];
        if (spin_of(p) != NULL)
            force[4 + d] += torque[d];
    }
}

void grain_jumped(struct fluid *fluid) {
    memory_free(fluid->jump);
    fluid->jump = NULL;
}

void grain_apply(const struct physics_context *context) {
    struct particles *p = context->particles;
    const double(*load)[6] = (const double(*)[6])fluid_load(p);
    for (size_t i = 0; i < p->owned; i++) {
        double push[3], *force = p->force + i * (size_t)p->force_stride;
        if (!grain_moves(context, i))
            continue;
        grain_push(context, i, push);
        if (isnan(load[i][0]))
            load_guess(context, i, force, push);
        for (int d = 0; d < context->box->dimension; d++)
            push[d] += load[i][d];
        grain_add(context, i, push, load[i] + 3);
    }
    grain_jumped(context->self);
}
