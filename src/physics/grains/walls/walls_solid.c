/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds what a solid near a wall may touch. Read wall_solid.h first. */
#include "physics/grains/walls/wall_solid.h"
#include "base/memory.h"
#include "base/scan.h"
#include "physics/grains/walls/walls_touch.h"
#include <string.h>

static void store(struct law_vector from, double to[3]) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

/* The candidate that is a particle; walls->candidates: none. */
static size_t candidate_of(const struct walls *walls, size_t particle) {
    size_t k = scan_first(walls->particle, walls->candidates, particle);
    return k < walls->candidates && walls->particle[k] == particle ? k : walls->candidates;
}

bool walls_group_next(const struct walls *walls, size_t particle, struct wall_group *group) {
    size_t k = candidate_of(walls, particle);
    if (k == walls->candidates)
        return false;
    size_t first = group->count > 0 ? group->first + group->count : walls->first[k], end = first;
    const struct wall_piece *piece = walls->piece;
    while (end < walls->first[k + 1] && piece[end].wall == piece[first].wall &&
           piece[end].image == piece[first].image)
        end++;
    *group = (struct wall_group){.first = first, .count = end - first};
    if (end == first)
        return false;
    group->wall = piece[first].wall;
    group->image = piece[first].image;
    return true;
}

void walls_group_shift(const struct walls *walls, const struct wall_group *group, double shift[3]) {
    store(walls_shift(walls, group->wall, group->image), shift);
}

bool walls_one_sided(const struct walls *walls, int wall) {
    const struct wall_options *options = &walls->wall[wall].options;
    return options->shape == WALL_PLANE || (options->shape == WALL_CYLINDER && options->length == 0);
}

void walls_probe_free(struct walls_probe *probe) {
    if (probe->scratch)
        walls_scratch_free(probe->scratch);
    memory_free(probe->scratch);
    memory_free(probe->corner);
    memory_free(probe->edge);
    memory_free(probe->vertex);
    *probe = (struct walls_probe){0};
}

void walls_group_touch(const struct walls *walls, const struct wall_group *group, const double x[3],
                       double radius, struct walls_probe *probe) {
    if (probe->scratch == NULL)
        probe->scratch = memory_allocate_zero(1, sizeof *probe->scratch, "walls");
    walls_scratch_reserve(probe->scratch, group->count);
    if (group->count > probe->corner_room) {
        probe->corner_room = 2 * group->count;
        probe->corner = memory_resize(probe->corner, probe->corner_room, sizeof *probe->corner, "walls");
    }
    probe->corners =
        walls_touch(walls, walls->piece + group->first, group->count, wall_vector(x), radius, probe->scratch);
    for (size_t c = 0; c < probe->corners; c++) {
        const struct wall_touch *touch = &probe->scratch->touch[c];
        probe->corner[c] = (struct wall_corner){.feature = touch->feature, .distance = touch->distance};
        store(touch->normal, probe->corner[c].normal);
    }
}

/* The square of the distance of the origin from a segment. */
static double segment_square(struct law_vector a, struct law_vector b) {
    struct law_vector along = law_add(b, -1, a);
    double square = law_dot(along, along), t = square > 0 ? -law_dot(a, along) / square : 0;
    struct law_vector near = law_add(a, t < 0 ? 0 : t > 1 ? 1 : t, along);
    return law_dot(near, near);
}

static struct wall_edge *edge_add(struct walls_probe *probe, struct law_vector a, struct law_vector b,
                                  int32_t feature) {
    if (probe->edges == probe->edge_room) {
        probe->edge_room = 2 * probe->edge_room + 64;
        probe->edge = memory_resize(probe->edge, probe->edge_room, sizeof *probe->edge, "walls");
    }
    struct wall_edge *edge = &probe->edge[probe->edges++];
    *edge = (struct wall_edge){.feature = feature, .faces = 1};
    store(a, edge->end[0]);
    store(b, edge->end[1]);
    return edge;
}

static struct wall_vertex *vertex_add(struct walls_probe *probe, struct law_vector place, int32_t feature) {
    if (probe->vertices == probe->vertex_room) {
        probe->vertex_room = 2 * probe->vertex_room + 64;
        probe->vertex = memory_resize(probe->vertex, probe->vertex_room, sizeof *probe->vertex, "walls");
    }
    struct wall_vertex *vertex = &probe->vertex[probe->vertices++];
    *vertex = (struct wall_vertex){.feature = feature};
    store(place, vertex->place);
    return vertex;
}

static void add_to(double sum[3], struct law_vector more) {
    sum[0] += more.x;
    sum[1] += more.y;
    sum[2] += more.z;
}

/* Side k of a triangle; corner: its corners about x. */
static void side_take(struct walls_probe *probe, const struct wall *wall,
                      const struct wall_triangle *triangle, const struct law_vector corner[3], int k,
                      double reach) {
    struct law_vector a = corner[k], b = corner[(k + 1) % 3], inward = triangle->inward[k];
    if (triangle->edge[k] < 0 || !(segment_square(a, b) < reach * reach))
        return;
    if (wall->moving)
        inward = wall_turn(wall->pose.rotation, inward);
    struct wall_edge *edge = NULL;
    for (size_t e = 0; e < probe->edges && edge == NULL; e++)
        if (probe->edge[e].feature == triangle->edge[k])
            edge = &probe->edge[e];
    if (edge)
        edge->faces++;
    else
        edge = edge_add(probe, a, b, triangle->edge[k]);
    add_to(edge->inward, inward);
}

static struct law_vector unit_of(struct law_vector a) {
    return law_scale(1 / sqrt(law_dot(a, a)), a);
}

static void corner_take(struct walls_probe *probe, const struct wall_triangle *triangle,
                        const struct law_vector corner[3], int k, double reach) {
    if (triangle->vertex[k] < 0 || !(law_dot(corner[k], corner[k]) < reach * reach))
        return;
    struct wall_vertex *vertex = NULL;
    for (size_t v = 0; v < probe->vertices && vertex == NULL; v++)
        if (probe->vertex[v].feature == triangle->vertex[k])
            vertex = &probe->vertex[v];
    if (vertex == NULL)
        vertex = vertex_add(probe, corner[k], triangle->vertex[k]);
    add_to(vertex->inward, unit_of(law_add(corner[(k + 1) % 3], -1, corner[k])));
    add_to(vertex->inward, unit_of(law_add(corner[(k + 2) % 3], -1, corner[k])));
}

/* The axis of a cylinder that is touched from outside, as far as it may count. */
static void axis_take(struct walls_probe *probe, const struct wall_cylinder *cylinder,
                      struct law_vector point, double reach) {
    double middle = -law_dot(point, cylinder->axis), low = middle - reach - cylinder->radius,
           high = middle + reach + cylinder->radius, half = 0.5 * cylinder->length;
    if (cylinder->length > 0) {
        low = low < -half ? -half : low > half ? half : low;
        high = high < -half ? -half : high > half ? half : high;
    }
    if (!(high > low))
        return;
    struct wall_edge *edge = edge_add(probe, law_add(point, low, cylinder->axis),
                                      law_add(point, high, cylinder->axis), WALL_CYLINDER_SHELL);
    edge->radius = cylinder->radius;
}

/* A rim of a finite cylinder as a polygon. */
static void rim_take(struct walls_probe *probe, const struct wall_cylinder *cylinder,
                     struct law_vector middle, int32_t feature, double reach) {
    struct law_vector axis = cylinder->axis, across = fabs(axis.x) < 0.6 ? (struct law_vector){1, 0, 0}
                                                                         : (struct law_vector){0, 1, 0};
    struct law_vector u = unit_of(law_cross(axis, across)), v = law_cross(axis, u), last = {0};
    for (int k = 0; k <= WALL_SOLID_SIDES; k++) {
        double angle = 2 * M_PI * k / WALL_SOLID_SIDES;
        struct law_vector place = law_add(middle, cylinder->radius * cos(angle), u);
        place = law_add(place, cylinder->radius * sin(angle), v);
        if (k > 0 && segment_square(last, place) < reach * reach)
            edge_add(probe, last, place, feature);
        if (k > 0 && law_dot(place, place) < reach * reach)
            vertex_add(probe, place, feature);
        last = place;
    }
}

static void cylinder_take(const struct wall *wall, struct law_vector at, double reach,
                          struct walls_probe *probe) {
    struct wall_cylinder cylinder = walls_cylinder(wall);
    struct law_vector point = law_add(cylinder.point, 1, at);
    if (!cylinder.inside)
        axis_take(probe, &cylinder, point, reach);
    if (cylinder.length == 0)
        return;
    rim_take(probe, &cylinder, law_add(point, 0.5 * cylinder.length, cylinder.axis), WALL_CYLINDER_UPPER,
             reach);
    rim_take(probe, &cylinder, law_add(point, -0.5 * cylinder.length, cylinder.axis), WALL_CYLINDER_LOWER,
             reach);
}

void walls_group_edges(const struct walls *walls, const struct wall_group *group, const double x[3],
                       double reach, struct walls_probe *probe) {
    const struct wall *wall = &walls->wall[group->wall];
    struct law_vector at = law_add(walls_shift(walls, group->wall, group->image), -1, wall_vector(x));
    probe->edges = probe->vertices = 0;
    if (wall->options.shape == WALL_CYLINDER)
        cylinder_take(wall, at, reach, probe);
    for (size_t p = group->first; wall->mesh && p < group->first + group->count; p++) {
        const struct wall_triangle *triangle = &wall->mesh->triangle[walls->piece[p].triangle];
        struct law_vector corner[3];
        for (int k = 0; k < 3; k++) {
            corner[k] = triangle->corner[k];
            if (wall->moving)
                corner[k] = wall_transform_point(&wall->pose, corner[k]);
            corner[k] = law_add(corner[k], 1, at);
        }
        for (int k = 0; k < 3; k++) {
            side_take(probe, wall, triangle, corner, k, reach);
            corner_take(probe, triangle, corner, k, reach);
        }
    }
    for (size_t e = 0; e < probe->edges; e++)
        if (probe->edge[e].faces == 1)
            memset(probe->edge[e].inward, 0, sizeof probe->edge[e].inward);
}
