/* SPDX-License-Identifier: BSD-3-Clause */
/* The free ones among the walls, and what is told of a wall. Read walls_free.h first. */
#include "physics/grains/walls/walls_free.h"
#include "physics/grains/walls/walls_parts.h"
#include "base/moments.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

bool walls_is_free(const struct walls *walls, int wall) {
    return walls->wall[wall].free != NULL;
}

bool walls_have_free(const struct walls *walls) {
    for (int w = 0; w < walls->count; w++)
        if (walls_is_free(walls, w))
            return true;
    return false;
}

void walls_set_gravity(struct walls *walls, const double gravity[3]) {
    memcpy(walls->gravity, gravity, sizeof walls->gravity);
}

void walls_stagger(struct walls *walls, const struct wall_push *push, double dt, double step) {
    for (int w = 0; w < walls->count; w++) {
        struct wall *wall = &walls->wall[w];
        if (wall->free == NULL || (dt == 0.0 && !wall->free->new_velocity && !wall->free->new_omega))
            continue;
        wall_free_stagger(wall->free, &push[w], walls->gravity, dt, step);
        wall->twist = wall_free_twist(wall->free);
    }
}

void walls_full_step(struct walls *walls, const struct wall_push *push, double dt) {
    for (int w = 0; w < walls->count; w++)
        if (walls->wall[w].free)
            wall_free_find_full(walls->wall[w].free, &push[w], walls->gravity, dt);
}

void walls_velocity(const struct walls *walls, int wall, double velocity[3], double omega[3]) {
    const struct wall_free *free = walls->wall[wall].free;
    struct wall_pose pose;
    walls_pose(walls, wall, &pose);
    memcpy(velocity, free ? free->full.velocity : pose.velocity, sizeof pose.velocity);
    memcpy(omega, free ? free->full.omega : pose.omega, sizeof pose.omega);
}

/* The rotation vector of a rotation: twice the angle of its quaternion, along the axis. */
static void vector_of(const double turn[9], double rotation[3]) {
    double q[4];
    moments_quaternion(turn, q);
    double sine = sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]), sign = q[0] < 0.0 ? -1.0 : 1.0;
    double factor = sine > 0.0 ? sign * 2.0 * atan2(sine, sign * q[0]) / sine : 0.0;
    for (int d = 0; d < 3; d++)
        rotation[d] = factor * q[1 + d];
}

void walls_rotation(const struct walls *walls, int wall, double rotation[3]) {
    const struct wall *w = &walls->wall[wall];
    vector_of(w->pose.rotation, rotation);
    for (int d = 0; w->free && w->free->options.freedom == WALL_FREE_ABOUT && d < 3; d++)
        rotation[d] = w->free->state.way * w->free->options.direction[d];
}

double walls_energy(const struct walls *walls) {
    double sum = 0.0;
    for (int w = 0; w < walls->count; w++)
        sum += walls->wall[w].free ? walls->wall[w].free->full.energy : 0.0;
    return sum;
}

double walls_motion(const struct walls *walls) {
    double sum = 0.0;
    for (int w = 0; w < walls->count; w++)
        sum += walls->wall[w].free ? walls->wall[w].free->full.motion : 0.0;
    return sum;
}

double walls_taken(const struct walls *walls) {
    double sum = 0.0;
    for (int w = 0; w < walls->count; w++)
        sum += walls->wall[w].free ? walls->wall[w].free->full.taken : 0.0;
    return sum;
}

int walls_free_numbers(struct walls *walls, int wall, double **number) {
    struct wall_free *free = walls->wall[wall].free;
    *number = free ? &free->state.known : NULL;
    return free ? (int)(sizeof free->state / sizeof free->state.known) : 0;
}

double walls_yield(const struct walls *walls, int wall, const double at[3], const double along[3]) {
    const struct wall_free *free = walls->wall[wall].free;
    return free ? wall_free_yield(free, wall_vector(at), wall_vector(along)) : 0.0;
}

double walls_yield_worst(const struct walls *walls, int wall, const double at[3]) {
    const struct wall_free *free = walls->wall[wall].free;
    return free ? wall_free_yield_worst(free, wall_vector(at)) : 0.0;
}

double walls_yield_most(const struct walls *walls, int wall) {
    const struct wall_free *free = walls->wall[wall].free;
    return free ? wall_free_yield_most(free) : 0.0;
}

double walls_yield_spread(const struct walls *walls, int wall) {
    const struct wall_free *free = walls->wall[wall].free;
    return free ? wall_free_yield_spread(free) : 0.0;
}

double walls_turn_yield(const struct walls *walls, int wall) {
    const struct wall_free *free = walls->wall[wall].free;
    return free ? wall_free_turn_yield(free) : 0.0;
}

double walls_whole_area(const struct walls *walls, int wall) {
    const struct wall *w = &walls->wall[wall];
    const double *edge = walls->box.edge, longest = law_max(law_max(edge[0], edge[1]), edge[2]);
    const double normal[3] = {w->axis.x, w->axis.y, w->axis.z};
    double length = w->options.length > 0.0 ? w->options.length : longest;
    bool flat = walls->box.dimension == 2;
    if (w->options.shape == WALL_PLANE)
        return walls_area(walls, wall, normal);
    if (w->options.shape == WALL_CYLINDER)
        return flat ? 0.0 : 2.0 * M_PI * w->options.radius * length;
    return flat ? 0.0 : wall_mesh_area(w->mesh) * (wall_mesh_open_edges(w->mesh, false) == 0 ? 1.0 : 2.0);
}

void walls_describe(const struct walls *walls, int wall, char *text, size_t room) {
    const struct wall *w = &walls->wall[wall];
    text[0] = '\0';
    if (w->free)
        wall_free_describe(w->free, text, room);
    if (w->field == NULL)
        return;
    struct wall_field_figures figures = wall_field_look(w->field);
    size_t used = strlen(text);
    snprintf(text + used, room - used, "  field of spacing %.3g, %.3g MiB, error up to %.2g", figures.spacing,
             (double)figures.bytes / 1048576.0, figures.error);
}
