/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls as triangles, planes and tubes. Read shapes.h first. */
#include "front/picture/shapes.h"

#include "base/memory.h"
#include "physics/grains/motion/integrator.h"

#include <math.h>
#include <string.h>

/* Turns and moves a point (box-relative) or a direction (without translation) by a pose. */
static void apply(const struct wall_pose *pose, const double origin[3], bool point, double v[3]) {
    double in[3], out[3];
    for (int d = 0; d < 3; d++)
        in[d] = point ? v[d] - origin[d] : v[d];
    for (int d = 0; d < 3; d++) {
        out[d] = point ? pose->translation[d] + origin[d] : 0.0;
        for (int e = 0; e < 3; e++)
            out[d] += pose->rotation[3 * d + e] * in[e];
    }
    memcpy(v, out, sizeof out);
}

static void normalise(double v[3]) {
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int d = 0; d < 3; d++)
        v[d] /= length;
}

static void add_mesh(struct shapes *shapes, const struct walls *walls, int wall) {
    double(*triangle)[9];
    size_t count = walls_triangles(walls, wall, &triangle);
    if (count == 0)
        return;
    shapes->triangle =
        memory_resize(shapes->triangle, shapes->triangles + count, sizeof *shapes->triangle, "triangles");
    memcpy(shapes->triangle + shapes->triangles, triangle, count * sizeof *triangle);
    shapes->triangles += count;
    memory_free(triangle);
}

static void add_wall(struct shapes *shapes, const struct walls *walls, int wall, const double origin[3]) {
    const struct wall_options *o = walls_options(walls, wall);
    struct wall_pose pose;
    walls_pose(walls, wall, &pose);
    if (wall_shape_meshed(o->shape)) {
        add_mesh(shapes, walls, wall);
    } else if (o->shape == WALL_PLANE) {
        struct shape_plane *plane = &shapes->plane[shapes->planes++];
        memcpy(plane->point, o->point, sizeof plane->point);
        memcpy(plane->normal, o->normal, sizeof plane->normal);
        apply(&pose, origin, true, plane->point);
        apply(&pose, origin, false, plane->normal);
        normalise(plane->normal);
    } else {
        struct shape_tube *tube = &shapes->tube[shapes->tubes++];
        tube->radius = o->radius;
        tube->length = o->length;
        memcpy(tube->point, o->point, sizeof tube->point);
        memcpy(tube->axis, o->axis, sizeof tube->axis);
        apply(&pose, origin, true, tube->point);
        apply(&pose, origin, false, tube->axis);
        normalise(tube->axis);
    }
}

/* Brings the walls to their places. */
static void place_walls(struct walls *walls, const struct scene *scene, const struct shapes_moment *moment) {
    struct wall_push push[WALLS_MAX] = {0};
    if (moment->walls == 0 && walls_move(walls) && moment->time > 0)
        walls_advance(walls, 0.0, moment->time, push);
    for (int k = 0; k < moment->walls; k++) {
        int wall = scene_wall(scene, moment->wall[k].name);
        if (wall >= 0)
            walls_set_pose(walls, wall, &moment->wall[k].pose);
    }
}

/* The walls of a scene, without those things that need particles. */
static bool make_walls(struct walls **walls, const struct scene *scene, const struct law *law,
                       struct error *error) {
    struct wall_options *option = memory_allocate((size_t)scene->walls, sizeof *option, "walls of a picture");
    for (int w = 0; w < scene->walls; w++) {
        option[w] = scene->wall[w];
        option[w].free.given = 0;
    }
    bool good = walls_create(walls, option, scene->walls, law, &scene->box, 1, error, NULL);
    memory_free(option);
    return good;
}

/* True if particles move a wall. */
static bool is_pushed(const struct wall_options *wall) {
    bool pushed = wall->free.given != 0;
    for (int k = 0; k < wall->motions; k++)
        pushed = pushed || wall->motion[k].kind == WALL_SERVO;
    return pushed;
}

bool shapes_make(struct shapes *shapes, const struct scene *scene, const struct shapes_moment *moment,
                 struct error *error) {
    struct law law; /* walls ask it for nothing but the number of values of a history */
    struct law_options options = scene->law;
    struct walls *walls;
    *shapes = (struct shapes){0};
    if (scene->walls == 0)
        return true;
    options.synchronised = integrator_find(scene->integrator)->synchronised;
    if (!law_prepare(&law, &options, scene->materials, scene->material, scene->law_pair, error))
        return false;
    if (!make_walls(&walls, scene, &law, error)) {
        law_free(&law);
        return false;
    }
    place_walls(walls, scene, moment);
    for (int wall = 0; wall < walls_count(walls); wall++) {
        add_wall(shapes, walls, wall, scene->box.origin);
        shapes->unknown = shapes->unknown || (moment->walls == 0 && is_pushed(&scene->wall[wall]));
    }
    walls_destroy(&walls);
    law_free(&law);
    return true;
}

void shapes_free(struct shapes *shapes) {
    memory_free(shapes->triangle);
    *shapes = (struct shapes){0};
}

static double along(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The polygon of a plane in a box: the points where the plane meets the edges, in order of their angle. */
static void cut_plane(struct shape_plane *plane, const double lower[3], const double upper[3]) {
    double angle[SHAPE_CORNERS_MAX], middle[3] = {0}, side[2][3];
    plane->corners = 0;
    for (int edge = 0; edge < 12; edge++) {
        int d = edge / 4, e = (d + 1) % 3, f = (d + 2) % 3;
        double at[3], from;
        at[e] = edge & 1 ? upper[e] : lower[e];
        at[f] = edge & 2 ? upper[f] : lower[f];
        at[d] = lower[d];
        from = along(plane->normal, plane->point) - along(plane->normal, at);
        double step = plane->normal[d] * (upper[d] - lower[d]);
        if (fabs(step) < 1e-12 * (upper[d] - lower[d]) || from / step < 0 || from / step > 1 ||
            plane->corners == SHAPE_CORNERS_MAX)
            continue;
        at[d] += from / step * (upper[d] - lower[d]);
        memcpy(plane->corner[plane->corners++], at, sizeof at);
    }
    for (int k = 0; k < plane->corners; k++)
        for (int d = 0; d < 3; d++)
            middle[d] += plane->corner[k][d] / plane->corners;
    int least = fabs(plane->normal[0]) < 0.6 ? 0 : 1;
    for (int d = 0; d < 3; d++)
        side[0][d] = (d == least) - plane->normal[d] * plane->normal[least];
    for (int d = 0; d < 3; d++)
        side[1][d] = plane->normal[(d + 1) % 3] * side[0][(d + 2) % 3] -
                     plane->normal[(d + 2) % 3] * side[0][(d + 1) % 3];
    for (int k = 0; k < plane->corners; k++) {
        double at[3], out[3];
        for (int d = 0; d < 3; d++)
            out[d] = plane->corner[k][d] - middle[d];
        memcpy(at, plane->corner[k], sizeof at);
        double turn = atan2(along(out, side[1]), along(out, side[0]));
        int place = k;
        for (; place > 0 && angle[place - 1] > turn; place--) {
            angle[place] = angle[place - 1];
            memcpy(plane->corner[place], plane->corner[place - 1], sizeof at);
        }
        angle[place] = turn;
        memcpy(plane->corner[place], at, sizeof at);
    }
}

static void cut_tube(struct shape_tube *tube, const double lower[3], const double upper[3]) {
    double low = tube->length > 0 ? -0.5 * tube->length : INFINITY, high = -low;
    for (int corner = 0; corner < 8 && tube->length == 0; corner++) {
        double at[3];
        for (int d = 0; d < 3; d++)
            at[d] = (corner >> d & 1 ? upper[d] : lower[d]) - tube->point[d];
        low = fmin(low, along(at, tube->axis));
        high = fmax(high, along(at, tube->axis));
    }
    for (int d = 0; d < 3; d++) {
        tube->end[0][d] = tube->point[d] + low * tube->axis[d];
        tube->end[1][d] = tube->point[d] + high * tube->axis[d];
    }
}

void shapes_cut(struct shapes *shapes, const double lower[3], const double upper[3]) {
    for (int k = 0; k < shapes->planes; k++)
        cut_plane(&shapes->plane[k], lower, upper);
    for (int k = 0; k < shapes->tubes; k++)
        cut_tube(&shapes->tube[k], lower, upper);
}
