/* SPDX-License-Identifier: BSD-3-Clause */
/* Closed surfaces: reading, depth, volume. Read wall_inside.h first. */
#include "physics/grains/walls/wall_inside.h"
#include "physics/grains/walls/wall_touch.h"
#include <math.h>

enum { TRIANGLES_MOST = 20000 };

static double length_of(struct law_vector a) {
    return sqrt(law_dot(a, a));
}

/* The solid angle of a triangle as seen from x, with a sign (Van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30
 * (1983) 125). */
static double solid_angle(const struct wall_triangle *triangle, struct law_vector x) {
    struct law_vector a = law_add(triangle->corner[0], -1.0, x), b = law_add(triangle->corner[1], -1.0, x),
                      c = law_add(triangle->corner[2], -1.0, x);
    double p = length_of(a), q = length_of(b), r = length_of(c);
    double below = p * q * r + law_dot(a, b) * r + law_dot(b, c) * p + law_dot(c, a) * q;
    return 2.0 * atan2(law_dot(a, law_cross(b, c)), below);
}

double wall_inside_depth(const struct wall_mesh *mesh, struct law_vector x) {
    double least = INFINITY, angle = 0.0;
    for (size_t t = 0; t < mesh->triangles; t++) {
        least = fmin(least, fabs(wall_touch_nearest(mesh, (int32_t)t, x, least).distance));
        angle += solid_angle(&mesh->triangle[t], x);
    }
    return fabs(angle) > 2.0 * M_PI ? least : 0.0;
}

double wall_inside_volume(const struct wall_mesh *mesh) {
    double six = 0.0;
    for (size_t t = 0; t < mesh->triangles; t++) {
        const struct law_vector *corner = mesh->triangle[t].corner;
        struct law_vector a = law_add(corner[0], -1.0, mesh->centre),
                          b = law_add(corner[1], -1.0, mesh->centre),
                          c = law_add(corner[2], -1.0, mesh->centre);
        six += law_dot(a, law_cross(b, c));
    }
    return fabs(six) / 6.0;
}

bool wall_inside_read(struct wall_mesh **mesh, const char *file, const struct wall_mesh_place *place,
                      const char *what, struct error *error) {
    struct mesh triangles;
    *mesh = NULL;
    if (!mesh_read(&triangles, file, "", error))
        return false;
    bool good = triangles.count <= TRIANGLES_MOST ||
                error_set(error, ERROR_USER, "%s: %s of %zu triangles; at most %d are allowed", file, what,
                          triangles.count, TRIANGLES_MOST);
    good = good && wall_mesh_create(mesh, &triangles, file, place, NULL, error);
    mesh_free(&triangles);
    size_t open = good ? wall_mesh_open_edges(*mesh, true) : 0;
    if (open > 0)
        error_set(
            error, ERROR_USER,
            "%s: is no closed surface of one orientation: %zu edges are not shared by two triangles, or by "
            "two that run round in different senses; %s needs a closed surface",
            file, open, what);
    return good && open == 0;
}
