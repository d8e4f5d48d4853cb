/* SPDX-License-Identifier: BSD-3-Clause */
/* How deep a place lies in the bounded solid of a wall. Read wall.h and wall_bulk.h first. */
#include "physics/grains/walls/walls_foot.h"
#include "base/memory.h"
#include <math.h>

/* Fills one line of nodes along x, whose first one lies outside: between two neighbours one of which is beyond the reach no surface lies. */
static void line_fill(struct wall_bulk *bulk, const struct wall *wall, size_t line) {
    bool solid = false;
    for (size_t x = 0; x < bulk->count[0]; x++) {
        size_t node = x + bulk->count[0] * line;
        double distance = walls_mesh_distance(wall, wall_bulk_node(bulk, node), bulk->reach);
        if (isfinite(distance))
            solid = distance < 0.0;
        bulk->solid[node] = solid;
    }
}

void walls_depth_prepare(struct walls *walls, int wall, double reach) {
    struct wall *w = &walls->wall[wall];
    wall_bulk_destroy(&w->bulk);
    if (w->mesh == NULL) {
        w->bulk = memory_allocate_zero(1, sizeof *w->bulk, "the solid of a wall");
        w->bulk->reach = reach;
        return;
    }
    w->bulk = wall_bulk_create(w->mesh->lower, w->mesh->upper, reach);
    size_t lines = w->bulk->count[1] * w->bulk->count[2];
#pragma omp parallel for schedule(dynamic, 8)
    for (size_t line = 0; line < lines; line++)
        line_fill(w->bulk, w, line);
}

/* The distance of a place in the wall's own image; on a mesh beyond the reach one of that size. */
static double depth_of(const struct walls *walls, const struct wall *wall, struct law_vector here) {
    const double reach = wall->bulk->reach;
    if (wall->mesh == NULL)
        return walls_cylinder_distance(walls, wall, here);
    struct law_vector x = walls_into_body(wall, here);
    double distance = walls_mesh_distance(wall, x, reach);
    if (isfinite(distance))
        return distance;
    return wall_bulk_solid(wall->bulk, x) ? -reach : reach;
}

double walls_depth(const struct walls *walls, int wall, const double x[3], double arm[3]) {
    const struct wall *w = &walls->wall[wall];
    double least = INFINITY;
    for (int k = 0; k < w->image_count; k++) {
        struct law_vector here = law_add(wall_vector(x), -1.0, walls_shift(walls, wall, w->image[k])),
                          from = law_add(here, -1.0, w->centre_now);
        double distance = depth_of(walls, w, here);
        if (!(distance < least))
            continue;
        least = distance;
        arm[0] = from.x;
        arm[1] = from.y;
        arm[2] = from.z;
    }
    return fmax(-w->bulk->reach, fmin(least, w->bulk->reach));
}

bool walls_bounded(const struct walls *walls, int wall) {
    const struct wall *w = &walls->wall[wall];
    if (w->options.shape == WALL_PLANE)
        return false;
    if (w->mesh == NULL)
        return !w->options.inside;
    struct law_vector outside = law_add(w->mesh->upper, w->mesh->radius, (struct law_vector){1.0, 1.0, 1.0});
    return walls_open_edges(walls, wall) == 0 && walls_mesh_distance(w, outside, INFINITY) > 0.0;
}
