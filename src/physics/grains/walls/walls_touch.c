/* SPDX-License-Identifier: BSD-3-Clause */
/* The contacts of one sphere with one wall: the shapes under one roof. */
#include "physics/grains/walls/walls_touch.h"
#include "base/memory.h"

struct wall_cylinder walls_cylinder(const struct wall *wall) {
    return (struct wall_cylinder){.point = wall->point_now,
                                  .axis = wall->axis_now,
                                  .radius = wall->options.radius,
                                  .length = wall->options.length,
                                  .inside = wall->options.inside};
}

static size_t touch_plane(const struct wall *wall, struct law_vector x, double radius,
                          struct wall_touch *touch) {
    double height = law_dot(wall->axis_now, law_add(x, -1.0, wall->point_now));
    *touch = (struct wall_touch){.distance = height, .normal = law_scale(-1.0, wall->axis_now)};
    return height < radius;
}

/* A cylinder and its images. */
static size_t touch_cylinder(const struct walls *walls, const struct wall_piece *piece, size_t pieces,
                             struct law_vector x, double radius, struct wall_touch *touch) {
    struct wall_cylinder cylinder = walls_cylinder(&walls->wall[piece->wall]);
    size_t count = 0;
    for (size_t k = 0; k < pieces; k++) {
        struct law_vector here = law_add(x, -1.0, walls_shift(walls, piece->wall, piece[k].image));
        if (wall_cylinder_touch(&cylinder, here, radius, &touch[count]))
            touch[count++].image = piece[k].image;
    }
    return count > 1 ? wall_cylinder_resolve(&cylinder, touch, count, radius) : count;
}

static size_t touch_mesh(const struct walls *walls, const struct wall_piece *piece, size_t pieces,
                         struct law_vector x, double radius, struct wall_scratch *scratch) {
    const struct wall *wall = &walls->wall[piece->wall];
    struct law_vector here = x;
    size_t count = 0;
    int32_t face = -1; /* a patch with a contact: the rest of it can have none */
    for (size_t k = 0; k < pieces; k++) {
        if (k == 0 || piece[k].image != piece[k - 1].image) {
            face = -1;
            here = walls_into_body(wall, law_add(x, -1.0, walls_shift(walls, piece->wall, piece[k].image)));
        }
        if (wall->mesh->triangle[piece[k].triangle].patch == face)
            continue;
        struct wall_nearest near = wall_touch_nearest(wall->mesh, piece[k].triangle, here, radius);
        if (!(near.distance < radius))
            continue;
        near.image = piece[k].image;
        scratch->near[count++] = near;
        face = near.kind == WALL_TOUCH_FACE ? near.feature : face;
    }
    count = wall_touch_resolve(wall->mesh, scratch->near, count, radius, scratch->touch);
    for (size_t k = 0; wall->moving && k < count; k++)
        scratch->touch[k].normal = wall_turn(wall->pose.rotation, scratch->touch[k].normal);
    return count;
}

/* The unit vector towards the surface of a field from a place in the body's frame, and the distance; false: too far. */
static bool toward_field(const struct wall *wall, struct law_vector x, struct law_vector *normal,
                         double *distance) {
    struct law_vector gradient;
    if (!wall_field_at(wall->field, x, distance, &gradient))
        return false;
    double slope = sqrt(law_dot(gradient, gradient)), sign = *distance < 0.0 ? 1.0 : -1.0;
    *normal = slope > 0.0 ? law_scale(sign / slope, gradient) : (struct law_vector){0.0, 0.0, -1.0};
    *distance = fabs(*distance);
    return true;
}

/* A field: of contacts through several images those that no nearer one hides. */
static size_t touch_field(const struct walls *walls, const struct wall_piece *piece, size_t pieces,
                          struct law_vector x, double radius, struct wall_touch *touch) {
    const struct wall *wall = &walls->wall[piece->wall];
    size_t count = 0;
    for (size_t k = 0; k < pieces; k++) {
        struct wall_touch one = {.triangle = WALL_PIECE_FIELD, .image = piece[k].image};
        struct law_vector here = law_add(x, -1.0, walls_shift(walls, piece->wall, piece[k].image));
        if (!toward_field(wall, walls_into_body(wall, here), &one.normal, &one.distance) ||
            !(one.distance < radius))
            continue;
        if (wall->moving)
            one.normal = wall_turn(wall->pose.rotation, one.normal);
        size_t at = count++;
        for (; at > 0 && one.distance < touch[at - 1].distance; at--)
            touch[at] = touch[at - 1];
        touch[at] = one;
    }
    return count > 1 ? wall_touch_show(touch, count, 1e-3 * radius) : count;
}

size_t walls_touch(const struct walls *walls, const struct wall_piece *piece, size_t pieces,
                   struct law_vector x, double radius, struct wall_scratch *scratch) {
    const struct wall *wall = &walls->wall[piece->wall];
    if (piece->triangle == WALL_PIECE_FIELD && wall->field)
        return touch_field(walls, piece, pieces, x, radius, scratch->touch);
    switch (wall->options.shape) {
    case WALL_PLANE:
        return touch_plane(wall, x, radius, scratch->touch);
    case WALL_CYLINDER:
        return touch_cylinder(walls, piece, pieces, x, radius, scratch->touch);
    default: /* made of triangles */
        break;
    }
    return touch_mesh(walls, piece, pieces, x, radius, scratch);
}

size_t walls_touch_face(const struct walls *walls, const struct wall_piece *piece, struct law_vector x,
                        double radius, struct wall_scratch *scratch) {
    const struct wall *wall = &walls->wall[piece->wall];
    struct law_vector here =
        walls_into_body(wall, law_add(x, -1.0, walls_shift(walls, piece->wall, piece->image)));
    struct wall_touch touch = wall_touch_face(wall->mesh, piece[piece->face - 1].triangle, here);
    if (!(touch.distance < radius))
        return 0;
    touch.image = piece->image;
    if (wall->moving)
        touch.normal = wall_turn(wall->pose.rotation, touch.normal);
    scratch->touch[0] = touch;
    return 1;
}

static struct law_vector unit(struct law_vector a, struct law_vector instead) {
    double length = sqrt(law_dot(a, a));
    return length > 0.0 ? law_scale(1.0 / length, a) : instead;
}

/* A vector of the wall half a step ago. */
static struct law_vector turn_half(const struct wall *wall, struct law_vector a, double dt) {
    return law_add(a, -0.5 * dt, law_cross(wall->twist.omega, a));
}

/* The vector from the centre to the point that touches, both half a step back; of an edge the part across it.
 */
static struct law_vector half_to(const struct wall *wall, const struct wall_touch *touch,
                                 const struct wall_sphere *sphere, double dt) {
    struct law_vector to = law_scale(touch->distance, touch->normal);
    struct law_vector rate =
        law_add(wall_twist_at(&wall->twist, law_add(sphere->x, 1.0, to)), -1.0, sphere->v);
    to = law_add(to, -0.5 * dt, rate);
    if (touch->kind != WALL_TOUCH_EDGE)
        return to;
    const struct law_vector *end = wall_touch_edge(wall->mesh, touch->feature);
    struct law_vector along = wall_turn(wall->pose.rotation, law_add(end[1], -1.0, end[0]));
    return law_project(to, unit(turn_half(wall, along, dt), along));
}

/* The normal of a field where the sphere was half a step ago, as the wall saw it. */
static struct law_vector half_field(const struct wall *wall, const struct wall_touch *touch,
                                    const struct wall_sphere *sphere, double dt) {
    struct law_vector rate = law_add(sphere->v, -1.0, wall_twist_at(&wall->twist, sphere->x)), normal;
    struct law_vector before = law_add(sphere->x, -0.5 * dt, rate);
    double distance;
    if (!toward_field(wall, walls_into_body(wall, before), &normal, &distance))
        return touch->normal;
    if (wall->moving)
        normal = wall_turn(wall->pose.rotation, normal);
    return unit(turn_half(wall, normal, dt), touch->normal);
}

struct law_vector walls_half_normal(const struct wall *wall, const struct wall_touch *touch,
                                    const struct wall_sphere *sphere, double dt) {
    bool cylinder = wall->options.shape == WALL_CYLINDER;
    if (wall->field)
        return half_field(wall, touch, sphere, dt);
    if (!cylinder && touch->kind == WALL_TOUCH_FACE)
        return wall->moving ? unit(turn_half(wall, touch->normal, dt), touch->normal) : touch->normal;
    if (!cylinder)
        return unit(half_to(wall, touch, sphere, dt), touch->normal);
    struct wall_cylinder half = walls_cylinder(wall);
    double distance;
    half.point = law_add(half.point, -0.5 * dt, wall_twist_at(&wall->twist, half.point));
    half.axis = unit(turn_half(wall, half.axis, dt), half.axis);
    return wall_cylinder_toward(&half, touch->feature, law_add(sphere->x, -0.5 * dt, sphere->v), &distance);
}

struct law_vector walls_toward(const struct wall *wall, int32_t feature, struct law_vector x,
                               double *distance) {
    if (wall->field) {
        struct law_vector n = {0.0, 0.0, -1.0};
        if (!toward_field(wall, walls_into_body(wall, x), &n, distance))
            *distance = INFINITY;
        return wall->moving ? wall_turn(wall->pose.rotation, n) : n;
    }
    if (wall->mesh) {
        struct law_vector n = wall_touch_toward(wall->mesh, feature, walls_into_body(wall, x), distance);
        return wall->moving ? wall_turn(wall->pose.rotation, n) : n;
    }
    if (wall->options.shape == WALL_CYLINDER) {
        struct wall_cylinder cylinder = walls_cylinder(wall);
        return wall_cylinder_toward(&cylinder, feature, x, distance);
    }
    *distance = law_dot(wall->axis_now, law_add(x, -1.0, wall->point_now));
    return law_scale(-1.0, wall->axis_now);
}

size_t walls_features(const struct wall *wall) {
    if (wall->field)
        return 1;
    if (wall->mesh)
        return wall_mesh_features(wall->mesh);
    return wall->options.shape == WALL_PLANE ? 1 : wall->options.length > 0.0 ? 3 : 1;
}

void walls_scratch_reserve(struct wall_scratch *scratch, size_t pieces) {
    if (pieces <= scratch->capacity)
        return;
    scratch->capacity = pieces + pieces / 4 + 64;
    scratch->near = memory_resize(scratch->near, scratch->capacity, sizeof *scratch->near, "walls");
    scratch->touch = memory_resize(scratch->touch, scratch->capacity, sizeof *scratch->touch, "walls");
    scratch->from = memory_resize(scratch->from, scratch->capacity, sizeof *scratch->from, "walls");
    scratch->taken = memory_resize(scratch->taken, scratch->capacity, sizeof *scratch->taken, "walls");
}

void walls_scratch_free(struct wall_scratch *scratch) {
    memory_free(scratch->near);
    memory_free(scratch->touch);
    memory_free(scratch->from);
    memory_free(scratch->taken);
    memory_free(scratch->batch);
    memory_free(scratch->load);
    memory_free(scratch->impedance);
    memory_free(scratch->exact);
    *scratch = (struct wall_scratch){0};
}
