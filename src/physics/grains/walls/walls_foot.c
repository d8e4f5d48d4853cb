/* SPDX-License-Identifier: BSD-3-Clause */
/* The point of a solid wall nearest to a place, for other physics than contacts. Read wall.h first. */
#include "base/memory.h"
#include "physics/grains/walls/walls_foot.h"
#include "physics/grains/walls/walls_touch.h"
#include <math.h>
#include <stdlib.h>

enum { NEAR_USUAL = 64 }; /* triangles near a place that need no memory of their own */

/* Where a surface is, as seen from a place: the unit vector away from the solid, and the distance, negative
 * inside. */
struct surface {
    double distance;
    struct law_vector normal;
};

static void put(double to[3], struct law_vector from) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

/* The surface of a solid cylinder, or of a bore: of the end planes and the shell, or of the rim between them. */
static struct surface cylinder_surface(const struct wall_cylinder *cylinder, bool flat, struct law_vector x) {
    struct law_vector axis = cylinder->axis;
    double height = law_dot(axis, law_add(x, -1.0, cylinder->point)), gap;
    struct law_vector out = law_scale(-1.0, wall_cylinder_toward(cylinder, WALL_CYLINDER_SHELL, x, &gap));
    double beyond = cylinder->length > 0.0 ? fabs(height) - 0.5 * cylinder->length : -INFINITY;
    if (flat && fabs(axis.z) > 0.5) /* a disc: its ends are out of the plane */
        beyond = beyond > 0.0 ? INFINITY : -INFINITY;
    if (beyond == INFINITY)
        return (struct surface){INFINITY, axis};
    struct law_vector end = law_scale(height < 0.0 ? -1.0 : 1.0, axis);
    if (beyond > 0.0 && gap > 0.0) {
        double distance = sqrt(beyond * beyond + gap * gap);
        return (struct surface){distance,
                                law_scale(1.0 / distance, law_add(law_scale(gap, out), beyond, end))};
    }
    return beyond > gap ? (struct surface){beyond, end} : (struct surface){gap, out};
}

/* The angle of a triangle at the corner nearest to a point, as seen from there. */
static double angle_at(const struct wall_triangle *triangle, struct law_vector point) {
    double best = INFINITY, angle = 0;
    for (int k = 0; k < 3; k++) {
        struct law_vector from = triangle->corner[k], off = law_add(point, -1.0, from),
                          a = law_add(triangle->corner[(k + 1) % 3], -1.0, from),
                          b = law_add(triangle->corner[(k + 2) % 3], -1.0, from), across = law_cross(a, b);
        if (!(law_dot(off, off) < best))
            continue;
        best = law_dot(off, off);
        angle = atan2(sqrt(law_dot(across, across)), law_dot(a, b));
    }
    return angle;
}

/* The share of a triangle in the normal of a point of the mesh: the angle that the triangle fills around the
 * point (Baerentzen and Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243). */
static double share_of(const struct wall_mesh *mesh, const struct wall_nearest *near, struct law_vector x) {
    if (near->kind == WALL_TOUCH_VERTEX)
        return angle_at(&mesh->triangle[near->triangle], law_add(x, 1.0, near->to));
    return near->kind == WALL_TOUCH_FACE ? 2.0 * M_PI : M_PI;
}

/* The surface of a mesh as seen from x, in the body's frame, from `count` triangles, of which one at least is
 * nearer than `reach`. */
static struct surface triangles_surface(const struct wall_mesh *mesh, const int32_t *triangle, size_t count,
                                        struct law_vector x, double reach) {
    struct wall_nearest best = {.distance = INFINITY};
    struct law_vector sum = {0.0, 0.0, 0.0};
    for (size_t k = 0; k < count; k++) {
        struct wall_nearest near = wall_touch_nearest(mesh, triangle ? triangle[k] : (int32_t)k, x, reach);
        if (near.distance < best.distance)
            best = near;
    }
    for (size_t k = 0; k < count; k++) {
        struct wall_nearest near = wall_touch_nearest(mesh, triangle ? triangle[k] : (int32_t)k, x, reach);
        struct law_vector off = law_add(near.to, -1.0, best.to);
        if (near.distance < reach && law_dot(off, off) <= 9.0 * mesh->tolerance * mesh->tolerance)
            sum = law_add(sum, share_of(mesh, &near, x),
                          mesh->patch[mesh->triangle[near.triangle].patch].normal);
    }
    double size = sqrt(law_dot(sum, sum)), side = -law_dot(sum, best.to);
    if (best.distance <= mesh->tolerance)
        return (struct surface){side < 0.0 ? -best.distance : best.distance,
                                law_scale(size > 0.0 ? 1.0 / size : 0.0, sum)};
    double way = side < 0.0 ? -1.0 : 1.0;
    return (struct surface){way * best.distance, law_scale(-way / best.distance, best.to)};
}

/* The surface of a field, in the body's frame; none beyond `reach`. */
static struct surface field_surface(const struct wall_field *field, struct law_vector x, double reach) {
    struct surface surface = {INFINITY, {0.0, 0.0, 1.0}};
    struct law_vector gradient;
    double distance;
    if (!wall_field_near(field, x, reach, &distance, &gradient))
        return surface;
    double slope = sqrt(law_dot(gradient, gradient));
    surface.distance = distance;
    if (slope > 0.0)
        surface.normal = law_scale(1.0 / slope, gradient);
    return surface;
}

/* The surface of a mesh, in the body's frame; none beyond `reach`. */
static struct surface mesh_surface(const struct wall *wall, struct law_vector x, double reach) {
    const struct wall_mesh *mesh = wall->mesh;
    const struct surface none = {INFINITY, {0.0, 0.0, 1.0}};
    int32_t usual[NEAR_USUAL];
    if (isinf(reach))
        return triangles_surface(mesh, NULL, mesh->triangles, x, reach);
    size_t count = wall_grid_query(wall->grid, x, reach, NULL);
    if (count == 0)
        return none;
    int32_t *near =
        count > NEAR_USUAL ? memory_allocate(count, sizeof *near, "triangles near a place") : usual;
    wall_grid_query(wall->grid, x, reach, near);
    struct surface surface = triangles_surface(mesh, near, count, x, reach);
    if (near != usual)
        memory_free(near);
    return surface;
}

/* The surface of one image of a wall. */
static struct surface surface_of(const struct walls *walls, const struct wall *wall, struct law_vector here,
                                 double reach) {
    if (wall->options.shape == WALL_PLANE)
        return (struct surface){law_dot(wall->axis_now, law_add(here, -1.0, wall->point_now)),
                                wall->axis_now};
    if (wall->options.shape == WALL_CYLINDER) {
        struct wall_cylinder cylinder = walls_cylinder(wall);
        return cylinder_surface(&cylinder, walls->box.dimension == 2, here);
    }
    struct law_vector x = walls_into_body(wall, here);
    struct surface surface =
        wall->field ? field_surface(wall->field, x, reach) : mesh_surface(wall, x, reach);
    if (wall->moving)
        surface.normal = wall_turn(wall->pose.rotation, surface.normal);
    return surface;
}

void walls_cover(struct walls *walls, double reach) {
    for (int w = 0; w < walls->count; w++)
        if (walls->wall[w].field)
            wall_field_cover(walls->wall[w].field, reach);
}

double walls_mesh_distance(const struct wall *wall, struct law_vector x, double reach) {
    return mesh_surface(wall, x, reach).distance;
}

double walls_cylinder_distance(const struct walls *walls, const struct wall *wall, struct law_vector here) {
    struct wall_cylinder cylinder = walls_cylinder(wall);
    return cylinder_surface(&cylinder, walls->box.dimension == 2, here).distance;
}

void walls_foot(const struct walls *walls, int wall, const double x[3], double reach,
                struct wall_foot *foot) {
    const struct wall *w = &walls->wall[wall];
    *foot = (struct wall_foot){.distance = INFINITY, .normal = {0.0, 0.0, 1.0}};
    for (int k = 0; k < w->image_count; k++) {
        struct law_vector here = law_add(wall_vector(x), -1.0, walls_shift(walls, wall, w->image[k]));
        struct surface surface = surface_of(walls, w, here, reach);
        if (!(surface.distance < foot->distance))
            continue;
        foot->distance = surface.distance;
        put(foot->normal, surface.normal);
        struct law_vector at = law_add(here, -surface.distance, surface.normal),
                          velocity = wall_twist_at(&w->twist, at);
        if (w->slides)
            velocity = law_add(velocity, 1.0, walls_slip(w, at, surface.normal));
        put(foot->velocity, velocity);
        put(foot->spin, w->slides ? law_add(w->twist.omega, 1.0, w->surface.omega) : w->twist.omega);
    }
}
