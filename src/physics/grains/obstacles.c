/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls as what grains meet beside grains: struct physics_obstacles. Read grains.h first. */
#include "engine/trip.h"
#include "physics/grains/grains_own.h"
#include <math.h>

static bool taken(const struct physics_context *context, const double x[3], double radius) {
    const struct grains *grains = context->self;
    return grains->walls && walls_overlap(grains->walls, x, radius);
}

static double displacement(const struct physics_context *context) {
    const struct grains *grains = context->self;
    return grains->walls ? walls_displacement(grains->walls) : 0;
}

static double work(const struct physics_context *context) {
    const struct grains *grains = context->self;
    return grains->walls ? walls_work(grains->walls) : 0;
}

static bool needed(const struct physics_context *context) {
    return grains_walls(context) && grains_touch(context);
}

/* The motion of walls is bounded in the region of the particles, including particles outside an open box. */
static void walls_reach(const struct physics_context *context, struct walls *walls) {
    const struct particles *particles = context->particles;
    double lower[3] = {INFINITY, INFINITY, INFINITY}, upper[3] = {-INFINITY, -INFINITY, -INFINITY};
    if (!walls_move(walls))
        return;
#pragma omp parallel for schedule(static) reduction(min : lower) reduction(max : upper)
    for (size_t k = 0; k < particles->owned; k++)
        for (int d = 0; d < 3; d++) {
            lower[d] = fmin(lower[d], particles->state[k].x[d]);
            upper[d] = fmax(upper[d], particles->state[k].x[d]);
        }
    comm_min(context->comm, lower, 3);
    comm_max(context->comm, upper, 3);
    walls_set_extent(walls, lower, upper);
}

static void search(const struct physics_context *context) {
    struct walls *walls = grains_walls(context);
    walls_reach(context, walls);
    walls_build(walls, context->particles, context->classes);
}

static void detach(const struct physics_context *context, struct history_rows *rows) {
    const struct grains *grains = context->self;
    if (grains->walls && grains->law.history_components)
        walls_detach(grains->walls, context->particles, rows);
}

static void attach(const struct physics_context *context, const struct history_rows *rows) {
    walls_attach(grains_walls(context), rows, context->particles);
}

/* The partners of walls depend on which particles are prescribed. */
static void changed(const struct physics_context *context) {
    const struct grains *grains = context->self;
    integrator_prescribe(context->particles, &grains->motion);
}

static void sound(const struct physics_context *context, struct error *error) {
    const struct walls *walls = grains_walls(context);
    double force[WALLS_MAX][6];
    if (walls == NULL)
        return;
    walls_forces(walls, force);
    for (int w = 0; w < walls_count(walls); w++) {
        struct wall_pose pose;
        walls_pose(walls, w, &pose);
        bool place = trip_finite(pose.rotation, 9) && trip_finite(pose.translation, 3) &&
                     trip_finite(pose.velocity, 3) && trip_finite(pose.omega, 3);
        if (!place || !trip_finite(force[w], 6))
            error_set(error, ERROR_PHYSICS, "guards.nan: %s wall '%s' is not finite at step %llu, t = %.9g",
                      place ? "the force on" : "the motion of", context->scene->wall[w].name,
                      (unsigned long long)context->clock->step, context->clock->time);
    }
}

const struct physics_obstacles grains_obstacles = {.taken = taken,
                                                   .displacement = displacement,
                                                   .work = work,
                                                   .needed = needed,
                                                   .search = search,
                                                   .detach = detach,
                                                   .attach = attach,
                                                   .changed = changed,
                                                   .finite = sound};
