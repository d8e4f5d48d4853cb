/* SPDX-License-Identifier: BSD-3-Clause */
/* Poses of walls, taken and set. Read wall.h first. */
#include "physics/grains/walls/walls_parts.h"
#include "base/memory.h"
#include <string.h>

static void put(double out[3], struct law_vector v) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

void walls_pose(const struct walls *walls, int wall, struct wall_pose *pose) {
    const struct wall *w = &walls->wall[wall];
    *pose = (struct wall_pose){.servo_speed = w->servo_speed, .servo_offset = w->servo_offset};
    memcpy(pose->rotation, w->pose.rotation, sizeof pose->rotation);
    memcpy(pose->translation, w->pose.translation, sizeof pose->translation);
    memcpy(pose->base_rotation, w->base.rotation, sizeof pose->base_rotation);
    memcpy(pose->base_translation, w->base.translation, sizeof pose->base_translation);
    memcpy(pose->force, walls->force[wall], sizeof pose->force);
    put(pose->velocity, wall_twist_at(&w->twist, w->centre_now));
    put(pose->omega, w->twist.omega);
    put(pose->centre, w->centre_now);
}

void walls_offset(const struct walls *walls, int wall, double offset[3]) {
    const struct wall *w = &walls->wall[wall];
    struct law_vector turned = law_add(wall_turn(w->pose.rotation, w->centre), -1.0, w->centre);
    put(offset, law_add(wall_vector(w->pose.translation), 1.0, turned));
}

/* A free wall whose state leads to its pose goes on. Else, as where its freedom is another one now, the pose is the one in which
 * it becomes free. */
static void go_on_free(struct wall *wall) {
    if (wall->free->state.known != 0.0) {
        wall_free_begin(wall->free, &wall->base);
        struct wall_transform moved = wall_free_place(wall->free),
                              there = wall_transform_compose(&moved, &wall->base);
        wall->free->state.known = wall_transform_near(&there, &wall->pose) ? 1.0 : 0.0;
    }
    if (wall->free->state.known == 0.0) {
        wall->base = wall->pose;
        wall_free_begin(wall->free, &wall->base);
    }
    wall->centre = wall_free_centre(wall->free, &wall->base);
    wall->twist = wall_free_twist(wall->free);
}

/* The load of the last evaluation, with its torque about the centre that the wall has now. */
static void set_force(const struct wall *wall, const struct wall_pose *pose, double force[6]) {
    struct law_vector arm = law_add(wall_vector(pose->centre), -1.0, wall->centre_now);
    memcpy(force, pose->force, sizeof pose->force);
    if (law_dot(arm, arm) > 0.0)
        put(force + 3, law_add(wall_vector(pose->force + 3), 1.0, law_cross(arm, wall_vector(pose->force))));
}

void walls_set_pose(struct walls *walls, int wall, const struct wall_pose *pose) {
    struct wall *w = &walls->wall[wall];
    struct wall_transform rest = wall_transform_identity();
    memcpy(w->pose.rotation, pose->rotation, sizeof pose->rotation);
    memcpy(w->pose.translation, pose->translation, sizeof pose->translation);
    memcpy(w->base.rotation, pose->base_rotation, sizeof pose->base_rotation);
    memcpy(w->base.translation, pose->base_translation, sizeof pose->base_translation);
    w->servo_offset = wall_motions_has_servo(w->motions) ? pose->servo_offset : 0.0;
    w->servo_speed = pose->servo_speed;
    w->twist = (struct wall_twist){0};
    if (w->free)
        go_on_free(w);
    bool anew = w->free && (w->free->new_velocity || w->free->new_omega);
    if (wall_moves(&w->options) && !anew) {
        w->twist.omega = wall_vector(pose->omega);
        w->twist.velocity =
            law_add(wall_vector(pose->velocity), -1.0, law_cross(w->twist.omega, wall_vector(pose->centre)));
    }
    w->moving = wall_moves(&w->options) || memcmp(&w->pose, &rest, sizeof rest) != 0;
    w->resumed = true;
    walls_follow(w);
    set_force(w, pose, walls->force[wall]);
}

size_t walls_triangles(const struct walls *walls, int wall, double (**triangles)[9]) {
    const struct wall *w = &walls->wall[wall];
    size_t count = w->mesh ? w->mesh->triangles : 0;
    *triangles = memory_allocate(count, sizeof **triangles, "triangles for output");
    for (size_t t = 0; t < count; t++)
        for (int k = 0; k < 3; k++) {
            double *out = (*triangles)[t] + 3 * k;
            put(out, wall_transform_point(&w->pose, w->mesh->triangle[t].corner[k]));
            for (int d = 0; d < 3; d++)
                out[d] += walls->box.origin[d];
        }
    return count;
}

double walls_turn(const struct walls *walls, int wall) {
    const struct wall_mesh *mesh = walls->wall[wall].mesh;
    return mesh && walls->wall[wall].field == NULL ? wall_mesh_turn(mesh, WALL_TOUCH_SMOOTH) : INFINITY;
}
