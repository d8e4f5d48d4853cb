/* SPDX-License-Identifier: BSD-3-Clause */
/* Generalised conjugate residuals over the velocities of grains. Read coupled_solve.h first. */
#include "physics/fluid/coupling/coupled_solve.h"
#include "kernel/particles/spin.h"
#include "base/memory.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/lattice/surface_feet.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/coupling/boundary_motion.h"
#include "kernel/particles/fields.h"
#include <math.h>
#include <string.h>

/* The equations are solved to this part of the forces; at most so many iterations. */
#define TOLERANCE 1e-3
enum { ITERATIONS = 20 };

/* By grain that the fluid moves: velocity and spin, or force x time and torque x time. */
typedef double vector[6];

struct joint {
    const struct physics_context *context;
    struct fluid *fluid;
    const struct path *path;
    size_t count, *grain;                         /* grains of this rank, their numbers */
    vector *inertia, *heavy;                      /* of the grain; with what the fluid adds to it, about */
    vector *start, *now, *held;                   /* velocities before, velocities, load before x time */
    vector *lack;                                 /* what the equations lack at `now` */
    vector *way[ITERATIONS], *change[ITERATIONS]; /* directions, and by how much the lack falls along them */
};

static void inertias_of(const struct joint *joint, size_t k) {
    const struct physics_context *context = joint->context;
    const struct fluid_options *options = joint->fluid->options;
    const struct particle_state *state = &context->particles->state[joint->grain[k]];
    double r = state->radius, mass = 1 / state->inverse_mass;
    double fluid = options->density * grain_displaced(context, r),
           diffused = options->viscosity / options->density * joint->path->dt;
    for (int d = 0; d < 3; d++) {
        joint->inertia[k][d] = mass;
        joint->inertia[k][3 + d] = 0.4 * mass * r * r;
        joint->heavy[k][d] =
            mass + grain_added(context, r) + fluid * diffused * (4.5 / (r * r) + 2 / (r * options->spacing));
        joint->heavy[k][3 + d] = 0.4 * mass * r * r + 6 * fluid * diffused;
    }
}

static vector *vectors(size_t count) {
    return memory_allocate_zero(count, sizeof(vector), "grains in a fluid");
}

static struct joint joint_make(const struct physics_context *context, const struct path *path) {
    const struct particles *p = context->particles;
    struct joint joint = {.context = context, .fluid = context->self, .path = path};
    double(*spin)[4] = spin_of(p);
    joint.grain = memory_allocate(p->owned, sizeof *joint.grain, "grains in a fluid");
    for (size_t i = 0; i < p->owned; i++)
        if (grain_moves(context, i))
            joint.grain[joint.count++] = i;
    vector **all[] = {&joint.inertia, &joint.heavy, &joint.start, &joint.now, &joint.held, &joint.lack};
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++)
        *all[k] = vectors(joint.count);
    for (size_t k = 0; k < joint.count; k++) {
        size_t i = joint.grain[k];
        inertias_of(&joint, k);
        memcpy(joint.start[k], p->state[i].v, 3 * sizeof(double));
        if (spin != NULL)
            memcpy(joint.start[k] + 3, spin[i], 3 * sizeof(double));
        for (int d = 0; d < 6; d++)
            joint.held[k][d] = path->dt * fluid_load(p)[i][d];
    }
    memcpy(joint.now, joint.start, joint.count * sizeof(vector));
    return joint;
}

static void joint_free(struct joint *joint) {
    vector *all[] = {joint->inertia, joint->heavy, joint->start, joint->now, joint->held, joint->lack};
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++)
        memory_free(all[k]);
    for (int k = 0; k < ITERATIONS; k++) {
        memory_free(joint->way[k]);
        memory_free(joint->change[k]);
    }
    memory_free(joint->grain);
}

/* Sum of a b / c over all grains of all ranks; c NULL: 1. */
static double product(const struct joint *joint, const vector *a, const vector *b, const vector *c) {
    double sum = 0;
    for (size_t k = 0; k < joint->count; k++)
        for (int d = 0; d < 6; d++)
            sum += a[k][d] * b[k][d] / (c != NULL ? c[k][d] : 1);
    comm_sum(joint->context->comm, &sum, 1);
    return sum;
}

/* a += part x b. */
static void add(const struct joint *joint, vector *a, double part, const vector *b) {
    for (size_t k = 0; k < joint->count; k++)
        for (int d = 0; d < 6; d++)
            a[k][d] += part * b[k][d];
}

/* Gives the grains, and their copies, velocities and spins; the feet follow. */
static void grains_set(const struct joint *joint, const vector *velocity) {
    const struct physics_context *context = joint->context;
    struct particles *p = context->particles;
    double(*spin)[4] = spin_of(p);
    for (size_t k = 0; k < joint->count; k++) {
        memcpy(p->state[joint->grain[k]].v, velocity[k], 3 * sizeof(double));
        if (spin != NULL)
            memcpy(spin[joint->grain[k]], velocity[k] + 3, 3 * sizeof(double));
    }
    flow_forward(joint->path->flow, FLOW_VELOCITY);
    if (context->ghosts != NULL && spin != NULL) {
        struct field_list list = fields_one(fields_find(p, "angular_velocity"));
        ghosts_forward_begin(context->ghosts, p, &list);
        ghosts_forward_end(context->ghosts, p);
    }
    surface_feet_mirror(context, joint->fluid);
}

/* Makes the step at given velocities of the grains: lack = dt (F - F0) - m (U - U*). */
static bool try_at(const struct joint *joint, const vector *velocity, vector *lack, struct error *error) {
    const struct physics_context *context = joint->context;
    const vector *load = (const vector *)fluid_load(context->particles);
    bool turns = spin_of(context->particles) != NULL;
    if (!moving_step_try(joint->path, error))
        return false;
    grain_load(context);
    for (size_t k = 0; k < joint->count; k++)
        for (int d = 0; d < 6; d++)
            lack[k][d] = (d < 3 ? d < context->box->dimension : turns)
                             ? joint->path->dt * load[joint->grain[k]][d] - joint->held[k][d] -
                                   joint->inertia[k][d] * (velocity[k][d] - joint->start[k][d])
                             : 0;
    return true;
}

/* The square of the forces on grains x time, for comparison. */
static double size_of(const struct joint *joint) {
    vector *size = vectors(joint->count);
    for (size_t k = 0; k < joint->count; k++) {
        grain_push(joint->context, joint->grain[k], size[k]);
        for (int d = 0; d < 6; d++)
            size[k][d] = joint->path->dt * (fabs(size[k][d]) +
                                            fabs(fluid_load(joint->context->particles)[joint->grain[k]][d])) +
                         fabs(joint->held[k][d]);
    }
    double square = product(joint, size, size, joint->heavy);
    memory_free(size);
    return square;
}

/* Iteration n, of generalised conjugate residuals: tries a way, takes out of it what earlier ways have, and goes along it as far as
 * makes the lack least. */
static bool improve(const struct joint *joint, int n, struct error *error) {
    vector *way = joint->way[n], *change = joint->change[n];
    vector *there = vectors(joint->count);
    for (size_t k = 0; k < joint->count; k++)
        for (int d = 0; d < 6; d++)
            way[k][d] = joint->lack[k][d] / joint->heavy[k][d];
    add(joint, there, 1, joint->now);
    add(joint, there, 1, way);
    grains_set(joint, there);
    bool good = try_at(joint, there, change, error);
    memory_free(there);
    if (!good)
        return false;
    for (size_t k = 0; k < joint->count; k++)
        for (int d = 0; d < 6; d++)
            change[k][d] = joint->lack[k][d] - change[k][d];
    for (int k = 0; k < n; k++) {
        double square = product(joint, joint->change[k], joint->change[k], joint->heavy);
        double part = square > 0 ? product(joint, change, joint->change[k], joint->heavy) / square : 0;
        add(joint, change, -part, joint->change[k]);
        add(joint, way, -part, joint->way[k]);
    }
    double square = product(joint, change, change, joint->heavy);
    double part = square > 0 ? product(joint, joint->lack, change, joint->heavy) / square : 0;
    add(joint, joint->now, part, way);
    add(joint, joint->lack, -part, change);
    return true;
}

/* The changes of velocities and spins, by particle number. */
static void jumps_keep(const struct joint *joint) {
    struct fluid *fluid = joint->fluid;
    memory_free(fluid->jump);
    fluid->jump =
        memory_allocate_zero(joint->context->particles->owned, sizeof *fluid->jump, "grains in a fluid");
    for (size_t k = 0; k < joint->count; k++)
        for (int d = 0; d < 6; d++)
            fluid->jump[joint->grain[k]][d] = joint->now[k][d] - joint->start[k][d];
}

/* Tells once of equations that are far from solved after n iterations: `lack` and `wanted` are squares. */
static void doubt(const struct joint *joint, int n, double lack, double wanted) {
    struct fluid *fluid = joint->fluid;
    if (!(lack > 100 * wanted) || wanted == 0 || fluid->apart)
        return;
    fluid->apart = true;
    if (fluid->first)
        log_tell(
            fluid->log,
            "warning: fluid.grains: after %d iterations force and motion of grains differ by %.2g of the "
            "forces at step %llu, t = %.9g: a shorter step or a finer spacing may help (said once)",
            n, TOLERANCE * sqrt(lack / wanted), (unsigned long long)joint->context->clock->step,
            joint->context->clock->time);
}

bool coupled_step(const struct physics_context *context, const struct path *path, struct error *error) {
    struct joint joint = joint_make(context, path);
    bool good = try_at(&joint, joint.now, joint.lack, error);
    double wanted = good ? TOLERANCE * TOLERANCE * size_of(&joint) : 0;
    int n = 0;
    for (; good && n < ITERATIONS && product(&joint, joint.lack, joint.lack, joint.heavy) > wanted; n++) {
        joint.way[n] = vectors(joint.count);
        joint.change[n] = vectors(joint.count);
        good = improve(&joint, n, error);
    }
    if (good && n > 0) {
        grains_set(&joint, joint.now);
        good = try_at(&joint, joint.now, joint.lack, error);
    }
    if (good)
        doubt(&joint, n, product(&joint, joint.lack, joint.lack, joint.heavy), wanted);
    jumps_keep(&joint);
    if (joint.fluid->riding)
        boundary_settle(
            context,
            joint.fluid); /* boundary particles have the velocities of their grains, as after a resume */
    joint_free(&joint);
    return good;
}
