/* SPDX-License-Identifier: BSD-3-Clause */
/* A closed mesh as a region. Read hull.h first. */
#include "front/pack/hull.h"
#include "base/memory.h"
#include "physics/grains/walls/wall_grid.h"
#include "physics/grains/walls/wall_inside.h"
#include "physics/grains/walls/wall_touch.h"

#include <math.h>

/* Pushes away from triangles in one move; triangles near a sphere that need no allocation. */
enum { PUSHES_MOST = 16, NEAR_MOST = 128 };
/* A move, as part of the room; a push goes this far beyond, against rounding. */
static const double move_most = 0.9, beyond = 1e-12;

/* The box around the triangles of a file. */
static void file_bounds(const struct mesh *file, double scale, double lower[3], double upper[3]) {
    lower[0] = lower[1] = lower[2] = INFINITY;
    upper[0] = upper[1] = upper[2] = -INFINITY;
    for (size_t t = 0; t < file->count; t++)
        for (int k = 0; k < 9; k++) {
            lower[k % 3] = fmin(lower[k % 3], scale * file->corner[t][k]);
            upper[k % 3] = fmax(upper[k % 3], scale * file->corner[t][k]);
        }
}

/* Of the triangles nearer to x than `reach` the nearest: its point relative to x, and its distance; false if there is none. Of
 * equally near triangles it is the first of the file, whatever the order of the cells. */
static bool nearest_triangle(const struct hull *hull, const double x[3], double reach, double to[3],
                             double *distance) {
    int32_t few[NEAR_MOST], *near = few, best = -1;
    struct law_vector at = {x[0], x[1], x[2]};
    size_t count = wall_grid_query(hull->grid, at, reach, NULL);
    *distance = INFINITY;
    if (count > NEAR_MOST)
        near = memory_allocate(count, sizeof *near, "triangles near a sphere");
    if (count > 0)
        wall_grid_query(hull->grid, at, reach, near);
    for (size_t k = 0; k < count; k++) {
        struct wall_nearest nearest = wall_touch_nearest(hull->mesh, near[k], at, reach);
        double length = sqrt(law_dot(nearest.to, nearest.to));
        if (length > *distance || (length == *distance && near[k] > best))
            continue;
        *distance = length;
        best = near[k];
        to[0] = nearest.to.x;
        to[1] = nearest.to.y;
        to[2] = nearest.to.z;
    }
    if (near != few)
        memory_free(near);
    return best >= 0;
}

static double distance_of(const double a[3], const double b[3]) {
    double square = 0;
    for (int c = 0; c < 3; c++)
        square += (a[c] - b[c]) * (a[c] - b[c]);
    return sqrt(square);
}

/* Pushes x away from triangles until none is nearer than `room`; false if that does not end. */
static bool push_clear(const struct hull *hull, double room, double x[3]) {
    double to[3], distance;
    for (int k = 0; k < PUSHES_MOST; k++) {
        if (!nearest_triangle(hull, x, room, to, &distance))
            return true;
        if (distance == 0)
            return false;
        for (int c = 0; c < 3; c++)
            x[c] -= to[c] * (room * (1 + beyond) - distance) / distance;
    }
    return false;
}

static void hold(void *context, const double from[3], double room, double x[3]) {
    const struct hull *hull = context;
    double moved = distance_of(x, from);
    double part = moved > move_most * room ? move_most * room / moved : 1;
    for (int c = 0; c < 3; c++)
        x[c] = from[c] + part * (x[c] - from[c]);
    if (push_clear(hull, room, x) && distance_of(x, from) < room)
        return;
    for (int c = 0; c < 3; c++)
        x[c] = from[c];
}

static double depth(void *context, const double x[3]) {
    const struct hull *hull = context;
    struct law_vector at = {x[0], x[1], x[2]};
    return wall_inside_depth(hull->mesh, at);
}

struct hull *hull_create(const char *file, double scale, struct error *error) {
    struct mesh mesh;
    struct wall_mesh_place place = {.scale = scale};
    struct hull *hull = memory_allocate_zero(1, sizeof *hull, "the inside of a mesh");
    bool good = mesh_read(&mesh, file, "", error);
    if (good) {
        file_bounds(&mesh, scale, hull->surface.lower, hull->surface.upper);
        mesh_free(&mesh);
    }
    if (!good || !wall_inside_read(&hull->mesh, file, &place, "a container", error)) {
        hull_destroy(&hull);
        return NULL;
    }
    hull->grid = wall_grid_create(hull->mesh);
    hull->surface.volume = wall_inside_volume(hull->mesh);
    hull->surface.context = hull;
    hull->surface.depth = depth;
    hull->surface.hold = hold;
    return hull;
}

void hull_destroy(struct hull **hull) {
    if (*hull == NULL)
        return;
    wall_grid_destroy(&(*hull)->grid);
    wall_mesh_destroy(&(*hull)->mesh);
    memory_free(*hull);
    *hull = NULL;
}
