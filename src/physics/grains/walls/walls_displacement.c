/* SPDX-License-Identifier: BSD-3-Clause */
/* How far walls have moved since the last rebuild, and how fast they are, as bounds. Read wall.h first. */
#include "physics/grains/walls/walls_parts.h"
#include <math.h>

static double length_of(struct law_vector a) {
    return sqrt(law_dot(a, a));
}

static struct law_vector corner_of(const struct walls *walls, int corner) {
    return (struct law_vector){walls->extent[corner & 1][0], walls->extent[corner >> 1 & 1][1],
                               walls->extent[corner >> 2][2]};
}

/* The largest displacement, across the plane, of a point of a plane within the extent of the particles: the
 * distance of a corner is linear in the corner. */
static double plane_displacement(const struct walls *walls, const struct wall *wall) {
    struct law_vector point = wall_transform_point(&wall->built, wall->point);
    struct law_vector normal = wall_turn(wall->built.rotation, wall->axis);
    double most = 0.0;
    for (int corner = 0; corner < 8; corner++) {
        struct law_vector x = corner_of(walls, corner);
        double before = law_dot(normal, law_add(x, -1.0, point));
        double now = law_dot(wall->axis_now, law_add(x, -1.0, wall->point_now));
        most = law_max(most, fabs(now - before));
    }
    return most;
}

/* The middle of the particles' extent, as seen from the wall's image. */
static struct law_vector middle_of(const struct walls *walls, const struct wall *wall) {
    struct law_vector lower = wall_vector(walls->extent[0]), upper = wall_vector(walls->extent[1]);
    return law_add(law_scale(0.5, law_add(lower, 1.0, upper)), -1.0, wall_vector(wall->wrap));
}

/* How far from there the wall matters, at most. */
static double far_of(const struct walls *walls, const struct wall *wall) {
    double far = length_of(law_add(wall_vector(walls->extent[1]), -1.0, wall_vector(walls->extent[0])));
    return far + (wall->images ? length_of(wall_vector(walls->box.edge)) : 0.0);
}

/* Displacement of a cylinder without ends: of its axis near the middle of the particles' extent, as seen from
 * the wall's image, plus the part of tilting over that extent. */
static double endless_displacement(const struct walls *walls, const struct wall *wall) {
    struct law_vector point = wall_transform_point(&wall->built, wall->point);
    struct law_vector axis = wall_turn(wall->built.rotation, wall->axis);
    struct law_vector middle = middle_of(walls, wall);
    struct law_vector before = law_add(point, law_dot(law_add(middle, -1.0, point), axis), axis);
    double reach = law_dot(law_add(middle, -1.0, wall->point_now), wall->axis_now);
    struct law_vector now = law_add(wall->point_now, reach, wall->axis_now);
    double tilt = length_of(law_add(wall->axis_now, -1.0, axis)) * far_of(walls, wall);
    return length_of(law_add(now, -1.0, before)) + tilt;
}

/* Displacement of a cylinder with ends: of its middle, plus the part of tilting at its rims. */
static double cylinder_displacement(const struct walls *walls, const struct wall *wall) {
    if (wall->options.length == 0.0)
        return endless_displacement(walls, wall);
    struct law_vector point = wall_transform_point(&wall->built, wall->point);
    struct law_vector axis = wall_turn(wall->built.rotation, wall->axis);
    double far = hypot(0.5 * wall->options.length, wall->options.radius);
    return length_of(law_add(wall->point_now, -1.0, point)) +
           length_of(law_add(wall->axis_now, -1.0, axis)) * far;
}

/* Displacement of a mesh: of its middle, plus the part of turning at its radius; |R - R'| = 2 sqrt(2)
 * sin(angle / 2). */
static double mesh_displacement(const struct wall *wall) {
    double square = 0.0;
    for (int k = 0; k < 9; k++) {
        double d = wall->pose.rotation[k] - wall->built.rotation[k];
        square += d * d;
    }
    struct law_vector before = wall_transform_point(&wall->built, wall->mesh->centre);
    struct law_vector now = wall_transform_point(&wall->pose, wall->mesh->centre);
    return length_of(law_add(now, -1.0, before)) + sqrt(0.5 * square) * wall->mesh->radius;
}

void walls_set_extent(struct walls *walls, const double lower[3], const double upper[3]) {
    for (int d = 0; d < 3; d++) {
        walls->extent[0][d] = fmin(0.0, lower[d]);
        walls->extent[1][d] = fmax(walls->box.edge[d], upper[d]);
    }
}

double walls_displacement(const struct walls *walls) {
    double most = 0.0;
    for (int w = 0; w < walls->count; w++) {
        const struct wall *wall = &walls->wall[w];
        if (!wall->moving)
            continue;
        double moved = wall->options.shape == WALL_PLANE      ? plane_displacement(walls, wall)
                       : wall->options.shape == WALL_CYLINDER ? cylinder_displacement(walls, wall)
                                                              : mesh_displacement(wall);
        most = law_max(most, moved);
    }
    return most;
}

/* The speed of a plane across itself at the corners of the extent. */
static double plane_speed(const struct walls *walls, const struct wall *wall) {
    double most = 0.0;
    for (int corner = 0; corner < 8; corner++)
        most = law_max(most,
                       fabs(law_dot(wall->axis_now, wall_twist_at(&wall->twist, corner_of(walls, corner)))));
    return most;
}

/* The speed of a point of the axis, and the part of tilting at the ends. */
static double cylinder_speed(const struct walls *walls, const struct wall *wall) {
    bool endless = wall->options.length == 0.0;
    struct law_vector point = wall->point_now;
    double far = hypot(0.5 * wall->options.length, wall->options.radius);
    if (endless) {
        double along = law_dot(law_add(middle_of(walls, wall), -1.0, point), wall->axis_now);
        point = law_add(point, along, wall->axis_now);
        far = far_of(walls, wall);
    }
    struct law_vector moves = wall_twist_at(&wall->twist, point);
    if (endless) /* along its axis it goes nowhere */
        moves = law_add(moves, -law_dot(moves, wall->axis_now), wall->axis_now);
    return length_of(moves) + length_of(law_cross(wall->twist.omega, wall->axis_now)) * far;
}

static double mesh_speed(const struct wall *wall) {
    struct law_vector middle = wall_transform_point(&wall->pose, wall->mesh->centre);
    return length_of(wall_twist_at(&wall->twist, middle)) + length_of(wall->twist.omega) * wall->mesh->radius;
}

double walls_speed(const struct walls *walls) {
    double most = 0.0;
    for (int w = 0; w < walls->count; w++) {
        const struct wall *wall = &walls->wall[w];
        if (!wall->moving)
            continue;
        double speed = wall->options.shape == WALL_PLANE      ? plane_speed(walls, wall)
                       : wall->options.shape == WALL_CYLINDER ? cylinder_speed(walls, wall)
                                                              : mesh_speed(wall);
        most = law_max(most, speed);
    }
    return most;
}
