/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes the triangles of rectangles, boxes, discs and cones. Read mesh_shape.h first. */
#include "physics/grains/walls/mesh_shape.h"
#include "physics/grains/walls/wall_motion.h"
#include "base/memory.h"
#include <math.h>

static void put(double out[3], struct law_vector v) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static void add_triangle(struct mesh *mesh, struct law_vector a, struct law_vector b, struct law_vector c) {
    double *corner = mesh->corner[mesh->count++];
    put(corner, a);
    put(corner + 3, b);
    put(corner + 6, c);
}

/* The corners a, b, c, d in the order of their edges. */
static void add_quad(struct mesh *mesh, const struct law_vector corner[4]) {
    add_triangle(mesh, corner[0], corner[1], corner[2]);
    add_triangle(mesh, corner[0], corner[2], corner[3]);
}

static bool make_rectangle(struct mesh *mesh, const struct wall_options *o, struct error *error) {
    struct law_vector point = wall_vector(o->point), along = wall_vector(o->along),
                      across = wall_vector(o->across), normal = law_cross(along, across);
    double area = sqrt(law_dot(normal, normal));
    if (!(area > 1e-9 * (law_dot(along, along) + law_dot(across, across))))
        return error_set(error, ERROR_USER,
                         "wall '%s': along and across span no rectangle; needed: two sides that are not "
                         "parallel, nor [0, 0, 0]",
                         o->name);
    struct law_vector far = law_add(law_add(point, 1.0, along), 1.0, across);
    add_quad(mesh,
             (struct law_vector[4]){point, law_add(point, 1.0, along), far, law_add(point, 1.0, across)});
    return true;
}

static bool make_box(struct mesh *mesh, const struct wall_options *o, struct error *error) {
    for (int d = 0; d < 3; d++)
        if (!(o->upper[d] > o->lower[d]))
            return error_set(error, ERROR_USER,
                             "wall '%s': the box's upper %c (%g) must be above its lower %c (%g)", o->name,
                             "xyz"[d], o -> upper[d], "xyz"[d], o -> lower[d]);
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            int e = (d + 1) % 3, f = (d + 2) % 3;
            struct law_vector corner[4];
            for (int k = 0; k < 4; k++) {
                int turn = side ? k : 3 - k; /* outward normals */
                double at[3];
                at[d] = side ? o->upper[d] : o->lower[d];
                at[e] = turn == 1 || turn == 2 ? o->upper[e] : o->lower[e];
                at[f] = turn >= 2 ? o->upper[f] : o->lower[f];
                corner[k] = wall_vector(at);
            }
            add_quad(mesh, corner);
        }
    return true;
}

/* A circle: its middle, two unit vectors across its axis, right-handed about the axis. */
struct circle {
    struct law_vector middle, first, second;
    double radius;
    int segments;
};

static struct circle circle_make(struct law_vector middle, struct law_vector axis, double radius,
                                 int segments) {
    struct law_vector aside = fabs(axis.x) < 0.6 * sqrt(law_dot(axis, axis))
                                  ? (struct law_vector){1.0, 0.0, 0.0}
                                  : (struct law_vector){0.0, 1.0, 0.0};
    struct law_vector first = law_cross(axis, aside);
    first = law_scale(1.0 / sqrt(law_dot(first, first)), first);
    struct law_vector second = law_cross(axis, first);
    second = law_scale(1.0 / sqrt(law_dot(second, second)), second);
    return (struct circle){
        .middle = middle, .first = first, .second = second, .radius = radius, .segments = segments};
}

/* Corner k of the circle's polygon; corner `segments` is corner 0 to the last bit. */
static struct law_vector circle_corner(const struct circle *circle, int k) {
    double angle = 2.0 * M_PI * (k % circle->segments) / circle->segments;
    struct law_vector at = law_add(circle->middle, circle->radius * cos(angle), circle->first);
    return law_add(at, circle->radius * sin(angle), circle->second);
}

/* The band between two polygons, of which the second may be a point. */
static void add_band(struct mesh *mesh, const struct circle *a, const struct circle *b) {
    for (int k = 0; k < a->segments; k++) {
        struct law_vector from = circle_corner(a, k), to = circle_corner(a, k + 1);
        if (b->radius > 0.0)
            add_quad(mesh, (struct law_vector[4]){from, to, circle_corner(b, k + 1), circle_corner(b, k)});
        else
            add_triangle(mesh, from, to, b->middle);
    }
}

static bool make_round(struct mesh *mesh, const struct wall_options *o, struct error *error) {
    bool disc = o->shape == WALL_DISC;
    struct law_vector axis = wall_vector(disc ? o->normal : o->axis), middle = wall_vector(o->point);
    double length = sqrt(law_dot(axis, axis)), end = disc ? o->hole : o->radius_end;
    if (!(length > 0.0 && isfinite(length)))
        return error_set(error, ERROR_USER, "wall '%s': its %s has no length", o->name,
                         disc ? "normal" : "axis");
    if (!(o->radius > 0.0 && end >= 0.0) || o->segments < 3)
        return error_set(error, ERROR_USER, "wall '%s': needs a radius above 0, and three segments or more",
                         o->name);
    if (disc && !(o->hole < o->radius))
        return error_set(error, ERROR_USER, "wall '%s': the hole (%g) must be smaller than the disc (%g)",
                         o->name, o->hole, o->radius);
    if (!disc && !(o->length > 0.0))
        return error_set(error, ERROR_USER, "wall '%s': a cone needs a length above 0", o->name);
    struct law_vector top = disc ? middle : law_add(middle, o->length / length, axis);
    struct circle first = circle_make(middle, axis, o->radius, o->segments),
                  second = circle_make(top, axis, end, o->segments);
    add_band(mesh, &first, &second);
    return true;
}

bool mesh_shape_make(struct mesh *mesh, const struct wall_options *options, struct error *error) {
    enum { BOX_TRIANGLES = 12 };
    bool round = options->shape == WALL_DISC || options->shape == WALL_CONE;
    size_t most = round && options->segments > 0 ? 2 * (size_t)options->segments : BOX_TRIANGLES;
    *mesh = (struct mesh){.corner = memory_allocate(most, sizeof *mesh->corner, "triangles")};
    bool good = options->shape == WALL_RECTANGLE ? make_rectangle(mesh, options, error)
                : options->shape == WALL_BOX     ? make_box(mesh, options, error)
                                                 : make_round(mesh, options, error);
    if (!good)
        mesh_free(mesh);
    return good;
}
