/* SPDX-License-Identifier: BSD-3-Clause */
/* Resolves the triangles near a sphere into contacts. Read wall_touch.h first. */
#include "physics/grains/walls/wall_touch.h"
#include <stdlib.h>

/* A corner or edge is dropped if a triangle there is nearer by this part of the radius: rounding. */
static const double touch_rounding = 1e-12;

static struct law_vector difference(struct law_vector a, struct law_vector b) {
    return law_add(a, -1.0, b);
}

/* Length and direction; `instead` where there is none. */
static struct law_vector direction_of(struct law_vector to, struct law_vector instead, double *length) {
    *length = sqrt(law_dot(to, to));
    return *length > 0.0 ? law_scale(1.0 / *length, to) : instead;
}

/* The point of the triangle's rim nearest to a centre whose foot lies outside. */
static void rim_nearest(const struct wall_triangle *triangle, struct law_vector x,
                        struct wall_nearest *near) {
    double best = INFINITY;
    for (int k = 0; k < 3; k++) {
        struct law_vector from = difference(triangle->corner[k], x);
        struct law_vector along = difference(triangle->corner[(k + 1) % 3], triangle->corner[k]);
        double t = -law_dot(from, along) / law_dot(along, along);
        struct law_vector to = t <= 0.0   ? from
                               : t >= 1.0 ? difference(triangle->corner[(k + 1) % 3], x)
                                          : law_add(from, t, along);
        double square = law_dot(to, to);
        if (!(square < best))
            continue;
        best = square;
        near->to = to;
        near->kind = t > 0.0 && t < 1.0 ? WALL_TOUCH_EDGE : WALL_TOUCH_VERTEX;
        near->feature = t <= 0.0   ? triangle->vertex[k]
                        : t >= 1.0 ? triangle->vertex[(k + 1) % 3]
                                   : triangle->edge[k];
    }
    near->distance = sqrt(best);
}

/* How far a point of the plane lies inside of the triangle. */
static double inside_of(const struct wall_triangle *triangle, struct law_vector foot) {
    double outside = -INFINITY;
    for (int k = 0; k < 3; k++)
        outside = law_max(outside, -law_dot(triangle->inward[k], difference(foot, triangle->corner[k])));
    return -outside;
}

static double height_of(const struct wall_patch *patch, struct law_vector x) {
    return law_dot(patch->normal, difference(x, patch->point));
}

double wall_touch_inside(const struct wall_mesh *mesh, int32_t t, struct law_vector x) {
    const struct wall_patch *patch = &mesh->patch[mesh->triangle[t].patch];
    return inside_of(&mesh->triangle[t], law_add(x, -height_of(patch, x), patch->normal));
}

/* From a centre at this height to the plane of a patch. */
static struct law_vector face_normal(const struct wall_patch *patch, double height) {
    return law_scale(height < 0.0 ? 1.0 : -1.0, patch->normal);
}

struct wall_touch wall_touch_face(const struct wall_mesh *mesh, int32_t t, struct law_vector x) {
    const struct wall_patch *patch = &mesh->patch[mesh->triangle[t].patch];
    double height = height_of(patch, x);
    return (struct wall_touch){.kind = WALL_TOUCH_FACE,
                               .feature = mesh->triangle[t].patch,
                               .triangle = t,
                               .distance = fabs(height),
                               .normal = face_normal(patch, height)};
}

struct wall_nearest wall_touch_nearest(const struct wall_mesh *mesh, int32_t t, struct law_vector x,
                                       double reach) {
    const struct wall_triangle *triangle = &mesh->triangle[t];
    const struct wall_patch *patch = &mesh->patch[triangle->patch];
    double height = height_of(patch, x);
    struct wall_nearest near = {.kind = WALL_TOUCH_FACE, .feature = triangle->patch, .triangle = t};
    near.distance = fabs(height);
    /* corners lie within the tolerance of the patch's plane */
    if (near.distance >= reach + mesh->tolerance)
        return near;
    near.to = law_scale(-height, patch->normal);
    double outside = law_max(0.0, -inside_of(triangle, law_add(x, 1.0, near.to)));
    if (outside <= mesh->slack)
        return near;
    double least = sqrt(height * height + outside * outside) - 2.0 * mesh->tolerance;
    if (least >= reach)
        near.distance = least;
    else
        rim_nearest(triangle, x, &near);
    return near;
}

/* Order in which contacts are taken: kind, distance, then whatever is the same in every run. */
static int nearest_compare(const void *a, const void *b) {
    const struct wall_nearest *x = a, *y = b;
    if (x->kind != y->kind)
        return x->kind < y->kind ? -1 : 1;
    if (x->distance != y->distance)
        return x->distance < y->distance ? -1 : 1;
    if (x->feature != y->feature)
        return x->feature < y->feature ? -1 : 1;
    if (x->triangle != y->triangle)
        return x->triangle < y->triangle ? -1 : 1;
    return x->image - y->image;
}

static void nearest_sort(struct wall_nearest *near, size_t count) {
    if (count > 32) {
        qsort(near, count, sizeof *near, nearest_compare);
        return;
    }
    for (size_t k = 1; k < count; k++) {
        struct wall_nearest one = near[k];
        size_t at = k;
        for (; at > 0 && nearest_compare(&one, &near[at - 1]) < 0; at--)
            near[at] = near[at - 1];
        near[at] = one;
    }
}

static bool triangle_has(const struct wall_triangle *t, int32_t feature) {
    return t->edge[0] == feature || t->edge[1] == feature || t->edge[2] == feature ||
           t->vertex[0] == feature || t->vertex[1] == feature || t->vertex[2] == feature;
}

/* True if no triangle at the edge or corner is nearer than it is. */
static bool nearest_of_all(const struct wall_mesh *mesh, const struct wall_nearest *near, size_t count,
                           const struct wall_nearest *one, double rounding) {
    for (size_t k = 0; k < count; k++)
        if (near[k].distance < one->distance - rounding && near[k].image == one->image &&
            triangle_has(&mesh->triangle[near[k].triangle], one->feature))
            return false;
    return true;
}

static bool hidden(const struct wall_touch *touch, size_t taken, struct law_vector to, double tolerance) {
    for (size_t k = 0; k < taken; k++)
        if (law_dot(to, touch[k].normal) >= touch[k].distance - tolerance)
            return true;
    return false;
}

/* True if contact l makes contact k part of a smooth patch: nearly the same normal, and nearer. */
static bool smooth_with(const struct wall_touch *touch, size_t l, size_t k) {
    static const double alike = 1.0 - 0.5 * WALL_TOUCH_SMOOTH * WALL_TOUCH_SMOOTH; /* cosine, to 2e-5 */
    double beyond = touch[k].distance - touch[l].distance;
    return (beyond > 0.0 || (beyond == 0.0 && l < k)) && law_dot(touch[k].normal, touch[l].normal) > alike;
}

/* Keeps only the nearest of contacts with nearly the same normal; the order stays. `drop` has room for a mark
 * of each contact. */
static size_t smooth(struct wall_touch *touch, size_t taken, struct wall_nearest *drop) {
    size_t left = 0;
    for (size_t k = 0; k < taken; k++) {
        drop[k].feature = 0;
        for (size_t l = 0; l < taken && drop[k].feature == 0; l++)
            drop[k].feature = l != k && smooth_with(touch, l, k);
    }
    for (size_t k = 0; k < taken; k++)
        if (drop[k].feature == 0)
            touch[left++] = touch[k];
    return left;
}

/* The contact at the nearest point of a triangle of this patch. */
static struct wall_touch contact_of(const struct wall_patch *patch, const struct wall_nearest *one) {
    struct wall_touch touch = {.kind = one->kind,
                               .feature = one->feature,
                               .triangle = one->triangle,
                               .image = one->image,
                               .distance = one->distance};
    if (one->kind == WALL_TOUCH_FACE)
        touch.normal = face_normal(patch, -law_dot(one->to, patch->normal));
    else
        touch.normal = direction_of(one->to, law_scale(-1.0, patch->normal), &touch.distance);
    return touch;
}

size_t wall_touch_resolve(const struct wall_mesh *mesh, struct wall_nearest *near, size_t count,
                          double radius, struct wall_touch *touch) {
    double tolerance = fmin(mesh->tolerance, 1e-3 * radius);
    size_t taken = 0;
    if (count > 1)
        nearest_sort(near, count);
    for (size_t k = 0; k < count; k++) {
        const struct wall_nearest *one = &near[k];
        if (!(one->distance < radius) || one->feature < 0 || hidden(touch, taken, one->to, tolerance))
            continue;
        if (one->kind != WALL_TOUCH_FACE && !nearest_of_all(mesh, near, count, one, touch_rounding * radius))
            continue;
        touch[taken++] = contact_of(&mesh->patch[mesh->triangle[one->triangle].patch], one);
    }
    return taken > 1 ? smooth(touch, taken, near) : taken;
}

size_t wall_touch_show(struct wall_touch *touch, size_t count, double tolerance) {
    size_t taken = 0;
    for (size_t k = 0; k < count; k++)
        if (!hidden(touch, taken, law_scale(touch[k].distance, touch[k].normal), tolerance))
            touch[taken++] = touch[k];
    return taken;
}

struct law_vector wall_touch_toward(const struct wall_mesh *mesh, int32_t feature, struct law_vector x,
                                    double *distance) {
    struct law_vector instead = {0.0, 0.0, -1.0};
    size_t f = (size_t)feature;
    if (f < mesh->patches) {
        double height = height_of(&mesh->patch[f], x);
        *distance = fabs(height);
        return face_normal(&mesh->patch[f], height);
    }
    if (f >= mesh->patches + mesh->edges)
        return direction_of(difference(mesh->vertex[f - mesh->patches - mesh->edges], x), instead, distance);
    const struct law_vector *end = wall_touch_edge(mesh, feature);
    struct law_vector from = difference(end[0], x), along = difference(end[1], end[0]);
    double t = -law_dot(from, along) / law_dot(along, along);
    return direction_of(law_add(from, t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t, along), instead, distance);
}

/* x seen from a cylinder: height along the axis, distance from it, and the direction away from it. */
struct polar {
    double height, radius;
    struct law_vector out;
};

static struct polar polar_of(const struct wall_cylinder *cylinder, struct law_vector x) {
    struct law_vector from = difference(x, cylinder->point), axis = cylinder->axis;
    struct law_vector across =
        fabs(axis.x) < 0.6 ? (struct law_vector){1.0, 0.0, 0.0} : (struct law_vector){0.0, 1.0, 0.0};
    struct polar polar = {.height = law_dot(from, axis)};
    polar.out = direction_of(law_add(from, -polar.height, axis), law_cross(axis, across), &polar.radius);
    if (polar.radius == 0.0)
        polar.out = law_scale(1.0 / sqrt(law_dot(polar.out, polar.out)), polar.out);
    return polar;
}

struct law_vector wall_cylinder_toward(const struct wall_cylinder *cylinder, int32_t feature,
                                       struct law_vector x, double *distance) {
    struct polar polar = polar_of(cylinder, x);
    double gap = cylinder->radius - polar.radius;
    if (feature == WALL_CYLINDER_SHELL) {
        *distance = cylinder->inside ? gap : -gap;
        return law_scale(cylinder->inside ? 1.0 : -1.0, polar.out);
    }
    double end = feature == WALL_CYLINDER_UPPER ? 0.5 * cylinder->length : -0.5 * cylinder->length;
    struct law_vector to = law_add(law_scale(gap, polar.out), end - polar.height, cylinder->axis);
    return direction_of(to, polar.out, distance);
}

bool wall_cylinder_touch(const struct wall_cylinder *cylinder, struct law_vector x, double radius,
                         struct wall_touch *touch) {
    struct polar polar = polar_of(cylinder, x);
    double half = 0.5 * cylinder->length;
    bool shell = cylinder->length == 0.0 || fabs(polar.height) <= half;
    *touch = (struct wall_touch){.kind = shell ? WALL_TOUCH_FACE : WALL_TOUCH_EDGE,
                                 .feature = shell                ? WALL_CYLINDER_SHELL
                                            : polar.height > 0.0 ? WALL_CYLINDER_UPPER
                                                                 : WALL_CYLINDER_LOWER};
    touch->normal = wall_cylinder_toward(cylinder, touch->feature, x, &touch->distance);
    return touch->distance < radius && (cylinder->length == 0.0 || touch->distance > -radius);
}

/* The order in which contacts are taken, as nearest_compare's. */
static bool touch_before(const struct wall_touch *a, const struct wall_touch *b) {
    if (a->kind != b->kind)
        return a->kind < b->kind;
    if (a->distance != b->distance)
        return a->distance < b->distance;
    return a->feature != b->feature ? a->feature < b->feature : a->image < b->image;
}

size_t wall_cylinder_resolve(const struct wall_cylinder *cylinder, struct wall_touch *touch, size_t count,
                             double radius) {
    double tolerance = fmin(1e-6 * fmax(cylinder->radius, cylinder->length), 1e-3 * radius);
    for (size_t k = 1; k < count; k++) {
        struct wall_touch one = touch[k];
        size_t at = k;
        for (; at > 0 && touch_before(&one, &touch[at - 1]); at--)
            touch[at] = touch[at - 1];
        touch[at] = one;
    }
    return wall_touch_show(touch, count, tolerance);
}

bool wall_cylinder_near(const struct wall_cylinder *cylinder, struct law_vector x, double reach) {
    struct polar polar = polar_of(cylinder, x);
    double gap = cylinder->inside ? cylinder->radius - polar.radius : polar.radius - cylinder->radius;
    if (cylinder->length == 0.0)
        return gap < reach;
    return fabs(gap) < reach && fabs(polar.height) < 0.5 * cylinder->length + reach;
}
