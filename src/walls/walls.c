/* SPDX-License-Identifier: BSD-3-Clause */
/* Life and motion of the walls (wall.h). */
#include "walls/mesh.h"
#include "walls/wall_area.h"
#include "walls/walls_near.h"
#include "walls/walls_touch.h"
#include "core/memory.h"
#include <string.h>

static void put(double out[3], struct law_vector v) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static struct law_vector box_vector(const double x[3], const double origin[3]) {
    return (struct law_vector){x[0] - origin[0], x[1] - origin[1], x[2] - origin[2]};
}

static bool wall_read_mesh(struct wall *wall, const struct box *box, FILE *notes, struct error *error) {
    const struct wall_options *o = &wall->options;
    struct wall_mesh_place place = {.scale = o->scale};
    struct mesh file;
    for (int d = 0; d < 3; d++)
        place.shift[d] = o->offset[d] - box->origin[d];
    if (!(o->scale > 0.0))
        return error_set(error, ERROR_USER, "wall '%s': scale is %g, must be above 0", o->name, o->scale);
    if (!mesh_read(&file, o->file, o->format, error))
        return false;
    bool good = wall_mesh_create(&wall->mesh, &file, o->file, &place, notes, error);
    mesh_free(&file);
    if (good)
        wall->grid = wall_grid_create(wall->mesh);
    return good;
}

/* Point and axis of a plane or cylinder. */
static bool wall_set_shape(struct wall *wall, const struct box *box, struct error *error) {
    const struct wall_options *o = &wall->options;
    bool plane = o->shape == WALL_PLANE;
    struct law_vector axis = wall_vector(plane ? o->normal : o->axis);
    double length = sqrt(law_dot(axis, axis));
    if (!(length > 0.0 && isfinite(length)))
        return error_set(error, ERROR_USER, "wall '%s': its %s has no length", o->name,
                         plane ? "normal" : "axis");
    wall->axis = fabs(length - 1.0) > 1e-15 ? law_scale(1.0 / length, axis) : axis;
    wall->point = box_vector(o->point, box->origin);
    if (!plane && !(o->radius > 0.0 && o->length >= 0.0))
        return error_set(error, ERROR_USER,
                         "wall '%s': a cylinder needs a radius above 0 and no negative length", o->name);
    return true;
}

/* Finds the images of a wall that particles can touch: those in periodic directions, except for planes and
 * infinite tubes, which a periodic box must not cut. */
static void wall_find_images(struct wall *wall, const struct box *box) {
    const struct wall_options *o = &wall->options;
    const double axis[3] = {wall->axis.x, wall->axis.y, wall->axis.z};
    bool endless = o->shape == WALL_CYLINDER && o->length == 0.0;
    wall->images = o->shape == WALL_MESH || (o->shape == WALL_CYLINDER && !(endless && o->inside));
    bool along[3];
    for (int d = 0; d < 3; d++)
        along[d] = wall->images && box->periodic[d] && !(endless && fabs(axis[d]) == 1.0);
    for (int z = -along[2]; z <= along[2]; z++)
        for (int y = -along[1]; y <= along[1]; y++)
            for (int x = -along[0]; x <= along[0]; x++)
                wall->image[wall->image_count++] = (int)image_code(x, y, z);
}

static void wall_find_reach(struct wall *wall) {
    const struct wall_options *o = &wall->options;
    const double axis[3] = {wall->axis.x, wall->axis.y, wall->axis.z};
    for (int d = 0; d < 3 && o->shape == WALL_CYLINDER; d++) {
        double along = o->length > 0.0 || axis[d] == 0.0 ? 0.5 * o->length * fabs(axis[d]) : INFINITY;
        wall->reach[d] = along + o->radius * sqrt(law_max(0.0, 1.0 - axis[d] * axis[d]));
    }
    for (size_t t = 0; wall->mesh && t < wall->mesh->triangles; t++)
        for (int c = 0; c < 3; c++) {
            double from[3];
            put(from, law_add(wall->mesh->triangle[t].corner[c], -1.0, wall->mesh->centre));
            for (int d = 0; d < 3; d++)
                wall->reach[d] = law_max(wall->reach[d], fabs(from[d]));
        }
}

/* Updates the members that follow from the pose. */
static void wall_update(struct wall *wall) {
    wall->point_now = wall_transform_point(&wall->pose, wall->point);
    wall->axis_now = wall_turn(wall->pose.rotation, wall->axis);
    wall->centre_now = wall_transform_point(&wall->pose, wall->centre);
}

static void wall_place(struct wall *wall, double t) {
    struct wall_transform motion = wall_mover_place(wall->mover, t, wall->servo_offset);
    wall->pose = wall_transform_compose(&motion, &wall->base);
    wall_update(wall);
}

static bool wall_create(struct wall *wall, const struct wall_options *options, const struct box *box,
                        FILE *notes, struct error *error) {
    wall->options = *options;
    wall->base = wall->pose = wall->built = wall_transform_identity();
    bool good = options->shape == WALL_MESH ? wall_read_mesh(wall, box, notes, error)
                                            : wall_set_shape(wall, box, error);
    wall_find_images(wall, box);
    wall_find_reach(wall);
    return good;
}

static bool walls_start_motions(struct walls *walls, int w, struct error *error) {
    struct wall *wall = &walls->wall[w];
    const struct box *box = &walls->box;
    if (!wall_area_targets(walls, w, error) ||
        !wall_mover_create(&wall->mover, &wall->options, box->origin, error) ||
        (box->dimension == 2 && !wall_mover_flat(wall->mover, error)))
        return false;
    if (!wall_mover_pivot(wall->mover, &wall->centre))
        wall->centre = wall->mesh ? wall->mesh->centre : wall->point;
    wall->moving = wall->options.motions > 0;
    wall->unit = wall_mover_servo_unit(wall->mover);
    wall_place(wall, 0.0);
    return true;
}

static void scratch_create(struct walls *walls) {
    walls->scratch = memory_allocate_zero((size_t)walls->threads, sizeof *walls->scratch, "walls");
    for (int t = 0; t < walls->threads; t++) {
        walls->scratch[t] = memory_allocate_zero(1, sizeof *walls->scratch[t], "walls");
        walls->scratch[t]->batch =
            memory_allocate_zero(1, sizeof *walls->scratch[t]->batch, "contacts with walls");
        walls->scratch[t]->force =
            memory_allocate_zero((size_t)walls->count, sizeof *walls->force, "forces on walls");
        walls->scratch[t]->impedance =
            memory_allocate_zero((size_t)walls->count, sizeof *walls->impedance, "forces on walls");
    }
}

bool walls_create(struct walls **walls, const struct wall_options *options, int count, const struct law *law,
                  const struct box *box, int threads, struct error *error, FILE *notes) {
    struct walls *w = memory_allocate_zero(1, sizeof *w, "walls");
    *walls = w;
    w->count = count;
    w->threads = threads;
    w->law = law;
    w->kernel = force_kernel_find(NULL);
    w->box = *box;
    walls_set_extent(w, box->edge, box->edge);
    box_image_shifts(box, w->shift);
    w->wall = memory_allocate_zero((size_t)count, sizeof *w->wall, "walls");
    w->force = memory_allocate_zero((size_t)count, sizeof *w->force, "forces on walls");
    w->impedance = memory_allocate_zero((size_t)count, sizeof *w->impedance, "forces on walls");
    w->first = memory_allocate_zero(1, sizeof *w->first, "walls");
    scratch_create(w);
    for (int k = 0; k < count; k++)
        if (!wall_create(&w->wall[k], &options[k], box, notes, error) || !walls_start_motions(w, k, error)) {
            walls_destroy(walls);
            return false;
        }
    walls_wrap(w);
    return true;
}

bool walls_choose(struct walls *walls, const char *kernel) {
    const struct force_kernel *found = force_kernel_find(kernel);
    if (found)
        walls->kernel = found;
    return found != NULL;
}

void walls_destroy(struct walls **walls) {
    struct walls *w = *walls;
    if (w == NULL)
        return;
    for (int k = 0; k < w->count; k++) {
        wall_mesh_destroy(&w->wall[k].mesh);
        wall_grid_destroy(&w->wall[k].grid);
        wall_mover_destroy(&w->wall[k].mover);
    }
    for (int t = 0; t < w->threads; t++) {
        walls_scratch_free(w->scratch[t]);
        memory_free(w->scratch[t]);
    }
    for (int b = 0; b < 2; b++) {
        memory_free(w->records[b].count);
        memory_free(w->records[b].key);
        memory_free(w->records[b].value);
    }
    memory_free(w->scratch);
    memory_free(w->wall);
    memory_free(w->force);
    memory_free(w->impedance);
    memory_free(w->exact);
    memory_free(w->particle);
    memory_free(w->first);
    memory_free(w->piece);
    memory_free(w->near_count);
    memory_free(w);
    *walls = NULL;
}

int walls_count(const struct walls *walls) {
    return walls->count;
}

const struct wall_options *walls_options(const struct walls *walls, int wall) {
    return &walls->wall[wall].options;
}

bool walls_have_servo(const struct walls *walls) {
    for (int w = 0; w < walls->count; w++)
        if (wall_mover_has_servo(walls->wall[w].mover))
            return true;
    return false;
}

double *walls_impedance(struct walls *walls, int wall) {
    return &walls->impedance[wall];
}

bool walls_move(const struct walls *walls) {
    for (int w = 0; w < walls->count; w++)
        if (walls->wall[w].options.motions > 0)
            return true;
    return false;
}

/* Finds the base of a wall whose pose was set from outside, at time t: the motions, applied to the base, give
 * this pose. A stored base that does so is kept, so that an unchanged run goes on with the same bits. */
static void wall_find_base(struct wall *wall, double t) {
    struct wall_transform motion = wall_mover_place(wall->mover, t, wall->servo_offset);
    struct wall_transform there = wall_transform_compose(&motion, &wall->base);
    if (!wall_transform_near(&there, &wall->pose)) {
        struct wall_transform back = wall_transform_inverse(&motion);
        wall->base = wall_transform_compose(&back, &wall->pose);
    }
    wall->resumed = false;
}

void walls_advance(struct walls *walls, double t, double dt, const struct wall_push *push) {
    for (int w = 0; w < walls->count; w++) {
        struct wall *wall = &walls->wall[w];
        if (wall->options.motions == 0)
            continue;
        if (wall->resumed)
            wall_find_base(wall, t);
        wall->servo_speed = push ? wall_mover_servo_follow(wall->mover, t, &push[w], wall->servo_speed) : 0.0;
        double half = wall->servo_offset + 0.5 * dt * wall->servo_speed;
        wall->twist = wall_mover_twist(wall->mover, t, dt, half, wall->servo_speed);
        wall->servo_offset += dt * wall->servo_speed;
        wall_place(wall, t + dt);
    }
}

void walls_at_end(struct walls *walls, double t, double dt) {
    double moment = 1e-4 * dt;
    for (int w = 0; w < walls->count; w++) {
        struct wall *wall = &walls->wall[w];
        if (wall->options.motions > 0)
            wall->twist =
                wall_mover_twist(wall->mover, t - moment, moment, wall->servo_offset, wall->servo_speed);
    }
}

/* The largest displacement, across the plane, of a point of a plane within the extent of the particles: the
 * distance of a corner is linear in the corner. */
static double plane_displacement(const struct walls *walls, const struct wall *wall) {
    struct law_vector point = wall_transform_point(&wall->built, wall->point);
    struct law_vector normal = wall_turn(wall->built.rotation, wall->axis);
    double most = 0.0;
    for (int corner = 0; corner < 8; corner++) {
        struct law_vector x = {walls->extent[corner & 1][0], walls->extent[corner >> 1 & 1][1],
                               walls->extent[corner >> 2][2]};
        double before = law_dot(normal, law_add(x, -1.0, point));
        double now = law_dot(wall->axis_now, law_add(x, -1.0, wall->point_now));
        most = law_max(most, fabs(now - before));
    }
    return most;
}

static double length_of(struct law_vector a) {
    return sqrt(law_dot(a, a));
}

/* Displacement of a cylinder without ends: of its axis near the middle of the particles' extent, as seen from
 * the wall's image, plus the part of tilting over that extent. */
static double endless_displacement(const struct walls *walls, const struct wall *wall) {
    struct law_vector point = wall_transform_point(&wall->built, wall->point);
    struct law_vector axis = wall_turn(wall->built.rotation, wall->axis);
    struct law_vector lower = wall_vector(walls->extent[0]), upper = wall_vector(walls->extent[1]);
    struct law_vector middle = law_scale(0.5, law_add(lower, 1.0, upper));
    middle = law_add(middle, -1.0, wall_vector(wall->wrap));
    struct law_vector before = law_add(point, law_dot(law_add(middle, -1.0, point), axis), axis);
    double reach = law_dot(law_add(middle, -1.0, wall->point_now), wall->axis_now);
    struct law_vector now = law_add(wall->point_now, reach, wall->axis_now);
    double far = length_of(law_add(upper, -1.0, lower));
    far += wall->images ? length_of(wall_vector(walls->box.edge)) : 0.0;
    double tilt = length_of(law_add(wall->axis_now, -1.0, axis)) * far;
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

void walls_set_pose(struct walls *walls, int wall, const struct wall_pose *pose) {
    struct wall *w = &walls->wall[wall];
    struct wall_transform rest = wall_transform_identity();
    memcpy(w->pose.rotation, pose->rotation, sizeof pose->rotation);
    memcpy(w->pose.translation, pose->translation, sizeof pose->translation);
    memcpy(w->base.rotation, pose->base_rotation, sizeof pose->base_rotation);
    memcpy(w->base.translation, pose->base_translation, sizeof pose->base_translation);
    w->servo_offset = wall_mover_has_servo(w->mover) ? pose->servo_offset : 0.0;
    w->servo_speed = pose->servo_speed;
    w->twist = (struct wall_twist){0};
    if (w->options.motions > 0) {
        w->twist.omega = wall_vector(pose->omega);
        w->twist.velocity =
            law_add(wall_vector(pose->velocity), -1.0, law_cross(w->twist.omega, wall_vector(pose->centre)));
    }
    w->moving = w->options.motions > 0 || memcmp(&w->pose, &rest, sizeof rest) != 0;
    memcpy(walls->force[wall], pose->force, sizeof pose->force);
    w->resumed = true;
    wall_update(w);
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
    return mesh ? wall_mesh_turn(mesh, WALL_TOUCH_SMOOTH) : INFINITY;
}
