/* SPDX-License-Identifier: BSD-3-Clause */
/* The containers of packings. Read container.h first. */
#include "front/pack/container.h"
#include "base/memory.h"
#include "physics/grains/walls/wall_grid.h"
#include "physics/grains/walls/wall_inside.h"
#include "physics/grains/walls/wall_touch.h"

#include <math.h>
#include <stdio.h>

/* Draws of a place inside a mesh; pushes away from triangles in one move; triangles near a sphere that need no allocation. */
enum { DRAWS_MOST = 20000, PUSHES_MOST = 16, NEAR_MOST = 128 };
/* A move inside a mesh, as part of the room; a push goes this far beyond, against rounding. */
static const double move_most = 0.9, beyond = 1e-12;
/* A periodic edge over the largest radius: a sphere must not meet its own image. */
static const double widths_least = 2.5;
/* No packing at random is denser. */
static const double solid_most = 0.95;

static void set_box(struct pack_container *container, const double edge[3], bool periodic) {
    container->box.dimension = 3;
    for (int c = 0; c < 3; c++) {
        container->box.edge[c] = edge[c];
        container->box.periodic[c] = periodic;
    }
}

/* The box around the triangles of a file. */
static void file_bounds(const struct mesh *file, double scale, double lower[3], double edge[3]) {
    double upper[3] = {-INFINITY, -INFINITY, -INFINITY};
    lower[0] = lower[1] = lower[2] = INFINITY;
    for (size_t t = 0; t < file->count; t++)
        for (int k = 0; k < 9; k++) {
            lower[k % 3] = fmin(lower[k % 3], scale * file->corner[t][k]);
            upper[k % 3] = fmax(upper[k % 3], scale * file->corner[t][k]);
        }
    for (int c = 0; c < 3; c++)
        edge[c] = upper[c] - lower[c];
}

static bool create_mesh(struct pack_container *container, const struct pack_options *o, struct error *error) {
    struct mesh file;
    struct wall_mesh_place place = {.scale = o->scaled};
    double edge[3];
    if (!mesh_read(&file, o->file, "", error))
        return false;
    file_bounds(&file, o->scaled, container->lower, edge);
    mesh_free(&file);
    for (int c = 0; c < 3; c++)
        place.shift[c] = -container->lower[c];
    if (!wall_inside_read(&container->mesh, o->file, &place, "a container", error))
        return false;
    set_box(container, edge, false);
    container->grid = wall_grid_create(container->mesh);
    container->volume = wall_inside_volume(container->mesh);
    return true;
}

bool container_create(struct pack_container *container, const struct pack_options *options, double solid,
                      struct error *error) {
    const struct pack_options *o = options;
    double r = o->radius, cube = o->box > 0 ? o->box : cbrt(solid / o->fraction);
    double edges[][3] = {[PACK_CUBE] = {cube, cube, cube},
                         [PACK_BOX] = {o->edges[0], o->edges[1], o->edges[2]},
                         [PACK_CYLINDER] = {2 * r, 2 * r, o->length},
                         [PACK_SPHERE] = {2 * r, 2 * r, 2 * r}};
    *container = (struct pack_container){.shape = o->shape, .radius = r};
    if (o->shape == PACK_MESH)
        return create_mesh(container, o, error);
    const double *edge = edges[o->shape];
    set_box(container, edge, o->walls == PACK_PERIODIC);
    container->volume = edge[0] * edge[1] * edge[2];
    if (o->shape == PACK_CYLINDER)
        container->volume = M_PI * r * r * o->length;
    if (o->shape == PACK_SPHERE)
        container->volume = 4 * M_PI / 3 * r * r * r;
    int round = o->shape == PACK_CYLINDER ? 2 : o->shape == PACK_SPHERE ? 3 : 0;
    for (int c = 0; c < round; c++)
        container->lower[c] = -r;
    return true;
}

void container_free(struct pack_container *container) {
    wall_grid_destroy(&container->grid);
    wall_mesh_destroy(&container->mesh);
}

bool container_takes(const struct pack_container *container, double room, double solid, struct error *error) {
    const struct box *box = &container->box;
    double least = fmin(box->edge[0], fmin(box->edge[1], box->edge[2]));
    double widths = container->shape == PACK_CUBE || box->periodic[0] ? widths_least : 2;
    if (solid > solid_most * container->volume)
        return error_set(
            error, ERROR_USER,
            "command line: the spheres' volume is %.3g, %.3g times that of the container: random "
            "packings hold about 0.64, of very different sizes up to 0.9",
            solid, solid / container->volume);
    if (least >= widths * room)
        return true;
    if (container->shape == PACK_CUBE)
        return error_set(
            error, ERROR_USER,
            "command line: a cube of edge %g is too small for spheres of radius %g: at least %g times as "
            "wide",
            least, room, widths);
    return error_set(error, ERROR_USER,
                     "command line: a container of %g x %g x %g is too small for spheres of radius %g: at "
                     "least %g times as wide",
                     box->edge[0], box->edge[1], box->edge[2], room, widths);
}

/* Of the triangles nearer to x than `reach` the nearest: its point relative to x, and its distance; false if there is none. Of
 * equally near triangles it is the first of the file, whatever the order of the cells. */
static bool nearest_triangle(const struct pack_container *container, const double x[3], double reach,
                             double to[3], double *distance) {
    int32_t few[NEAR_MOST], *near = few, best = -1;
    struct law_vector at = {x[0], x[1], x[2]};
    size_t count = wall_grid_query(container->grid, at, reach, NULL);
    *distance = INFINITY;
    if (count > NEAR_MOST)
        near = memory_allocate(count, sizeof *near, "triangles near a sphere");
    if (count > 0)
        wall_grid_query(container->grid, at, reach, near);
    for (size_t k = 0; k < count; k++) {
        struct wall_nearest nearest = wall_touch_nearest(container->mesh, near[k], at, reach);
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
static bool push_clear(const struct pack_container *container, double room, double x[3]) {
    double to[3], distance;
    for (int k = 0; k < PUSHES_MOST; k++) {
        if (!nearest_triangle(container, x, room, to, &distance))
            return true;
        if (distance == 0)
            return false;
        for (int c = 0; c < 3; c++)
            x[c] -= to[c] * (room * (1 + beyond) - distance) / distance;
    }
    return false;
}

static void hold_in_mesh(const struct pack_container *container, const double from[3], double room,
                         double x[3]) {
    double moved = distance_of(x, from);
    double part = moved > move_most * room ? move_most * room / moved : 1;
    for (int c = 0; c < 3; c++)
        x[c] = from[c] + part * (x[c] - from[c]);
    if (push_clear(container, room, x) && distance_of(x, from) < room)
        return;
    for (int c = 0; c < 3; c++)
        x[c] = from[c];
}

/* The square of the distance from the axis of a cylinder or the centre of a sphere, in the first `n` coordinates. */
static double square_off(const struct pack_container *container, int n, const double x[3]) {
    double square = 0;
    for (int c = 0; c < n; c++)
        square += (x[c] - container->radius) * (x[c] - container->radius);
    return square;
}

static void hold_round(const struct pack_container *container, int n, double room, double x[3]) {
    double square = square_off(container, n, x), most = container->radius - room;
    double part = most / sqrt(square);
    for (int c = 0; c < n && square > most * most; c++)
        x[c] = container->radius + part * (x[c] - container->radius);
}

void container_hold(const struct pack_container *container, const double from[3], double room, double x[3]) {
    const struct box *box = &container->box;
    if (container->shape == PACK_MESH) {
        hold_in_mesh(container, from, room, x);
        return;
    }
    if (container->shape == PACK_SPHERE)
        hold_round(container, 3, room, x);
    if (container->shape == PACK_CYLINDER)
        hold_round(container, 2, room, x);
    for (int c = 0; c < 3; c++)
        if (!box->periodic[c])
            x[c] = fmin(fmax(x[c], room), box->edge[c] - room);
}

/* True if a sphere of this room around x, which lies in the box, lies in the container. */
static bool contains(const struct pack_container *container, double room, const double x[3]) {
    int round = container->shape == PACK_SPHERE ? 3 : container->shape == PACK_CYLINDER ? 2 : 0;
    double most = container->radius - room;
    if (container->shape == PACK_MESH) {
        struct law_vector at = {x[0], x[1], x[2]};
        return wall_grid_query(container->grid, at, room, NULL) == 0 &&
               wall_inside_depth(container->mesh, at) >= room;
    }
    return round == 0 || square_off(container, round, x) <= most * most;
}

bool container_draw(const struct pack_container *container, double room, struct random_sequence *random,
                    double x[3]) {
    for (int draw = 0; draw < DRAWS_MOST; draw++) {
        for (int c = 0; c < 3; c++) {
            double margin = container->box.periodic[c] ? 0 : room;
            x[c] = margin + (container->box.edge[c] - 2 * margin) * random_uniform(random);
        }
        if (contains(container, room, x))
            return true;
    }
    return false;
}

void container_describe(const struct pack_container *container, const struct pack_options *options,
                        char *text, size_t size) {
    const double *edge = container->box.edge;
    const char *sides = options->walls == PACK_HARD ? "hard walls" : "periodic";
    switch (container->shape) {
    case PACK_CUBE:
        snprintf(text, size, "a cube of edge %.6g, %s", edge[0], sides);
        return;
    case PACK_BOX:
        snprintf(text, size, "a box of %.6g x %.6g x %.6g, %s", edge[0], edge[1], edge[2], sides);
        return;
    case PACK_CYLINDER:
        snprintf(text, size, "a cylinder of radius %.6g and length %.6g", container->radius, edge[2]);
        return;
    case PACK_SPHERE:
        snprintf(text, size, "a sphere of radius %.6g", container->radius);
        return;
    default:
        snprintf(text, size, "%.200s, which encloses %.6g", options->file, container->volume);
    }
}
