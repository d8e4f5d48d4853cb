/* SPDX-License-Identifier: BSD-3-Clause */
/* Mass, centre of mass and inertia of a free wall. Read wall_free.h first. */
#include "physics/grains/walls/wall_free.h"
#include "base/eigen3.h"
#include "base/memory.h"
#include "base/moments.h"
#include <math.h>
#include <string.h>

/* What follows from the shape at rest, box-relative. */
struct form {
    struct moments moments; /* volume 0: the shape has none; gyration NAN: it has no middle */
    double extent;
};

static double length_of(struct law_vector a) {
    return sqrt(law_dot(a, a));
}

/* Adds (a - b) n n^T + b 1. */
static void spread(double tensor[9], double along, double across, const double n[3]) {
    for (int d = 0; d < 3; d++)
        for (int e = 0; e < 3; e++)
            tensor[3 * d + e] += (along - across) * n[d] * n[e] + (d == e ? across : 0.0);
}

/* A cylinder: a solid one that is felt from outside, else a tube without ends. */
static void form_of_cylinder(struct form *form, const struct wall_options *o, struct law_vector point) {
    double square = o->radius * o->radius, ends = o->length * o->length / 12.0;
    struct law_vector axis = wall_vector(o->axis);
    axis = law_scale(1.0 / length_of(axis), axis);
    const double n[3] = {axis.x, axis.y, axis.z};
    memcpy(form->moments.centre, &point, sizeof form->moments.centre);
    form->extent = hypot(o->radius, 0.5 * o->length);
    if (o->length == 0.0)
        return;
    memset(form->moments.gyration, 0, sizeof form->moments.gyration);
    if (o->inside)
        spread(form->moments.gyration, square, 0.5 * square + ends, n);
    else
        spread(form->moments.gyration, 0.5 * square, 0.25 * square + ends, n);
    form->moments.volume = o->inside ? 0.0 : M_PI * square * o->length;
}

/* A mesh: the solid in a closed one, else a sheet. */
static void form_of_mesh(struct form *form, const struct wall_mesh *mesh) {
    double(*corner)[9] = memory_allocate(mesh->triangles, sizeof *corner, "triangles of a free wall");
    bool closed = wall_mesh_open_edges(mesh, true) == 0;
    for (size_t t = 0; t < mesh->triangles; t++)
        memcpy(corner[t], mesh->triangle[t].corner, sizeof corner[t]);
    if (closed)
        moments_solid((const double(*)[9])corner, mesh->triangles, &form->moments);
    else
        moments_sheet((const double(*)[9])corner, mesh->triangles, &form->moments);
    if (!closed)
        form->moments.volume = 0.0;
    for (size_t k = 0; k < 3 * mesh->triangles; k++) {
        struct law_vector from =
            law_add(mesh->triangle[k / 3].corner[k % 3], -1.0, wall_vector(form->moments.centre));
        form->extent = law_max(form->extent, length_of(from));
    }
    memory_free(corner);
}

static struct law_vector box_place(const double x[3], const struct box *box) {
    return (struct law_vector){x[0] - box->origin[0], x[1] - box->origin[1], x[2] - box->origin[2]};
}

static void form_make(struct form *form, const struct wall_options *options, const struct wall_mesh *mesh,
                      const struct box *box) {
    struct law_vector point = box_place(options->point, box);
    *form = (struct form){.extent = 0.0};
    for (int k = 0; k < 9; k++)
        form->moments.gyration[k] = NAN;
    memcpy(form->moments.centre, &point, sizeof form->moments.centre);
    if (mesh)
        form_of_mesh(form, mesh);
    else if (options->shape == WALL_CYLINDER)
        form_of_cylinder(form, options, point);
}

/* What the user gives instead. */
static void form_take(struct form *form, const struct wall_free_options *options, double mass,
                      const struct box *box) {
    static const int place[9] = {0, 3, 4, 3, 1, 5, 4, 5, 2};
    struct law_vector centre = box_place(options->centre, box);
    if (options->centre_given)
        memcpy(form->moments.centre, &centre, sizeof form->moments.centre);
    for (int k = 0; options->inertia_given && k < 9; k++)
        form->moments.gyration[k] = options->inertia[place[k]] / mass;
}

static bool refuse(const char *name, const char *why, struct error *error) {
    return error_set(error, ERROR_USER, "wall '%s': free: %s", name, why);
}

static const char no_inertia[] =
    "no inertia follows from the shape; give its inertia, or a freedom without turning";

/* Of a wall that turns in all directions. In two dimensions it turns about z alone, which any axes allow that are those of a
 * ball with the moment about z. */
static bool turns_all(struct wall_free *free, const char *name, const double gyration[9],
                      struct error *error) {
    double value[3], turn[9], flat[9] = {0};
    if (isnan(gyration[0]))
        return refuse(name, no_inertia, error);
    for (int d = 0; d < 3; d++)
        flat[4 * d] = gyration[8];
    eigen3_axes(free->flat ? flat : gyration, value, turn);
    moments_quaternion(turn, free->axes_rest);
    for (int d = 0; d < 3; d++)
        free->inertia[d] = free->mass * value[d];
    return (value[0] > 0.0 && value[0] + value[1] >= value[2] * (1.0 - 1e-9)) ||
           refuse(name,
                  "no body has such moments of inertia: the principal ones must be above 0, and none larger "
                  "than "
                  "the sum of the other two; give its inertia",
                  error);
}

/* Of a wall that turns about an axis: by the parallel axis through the centre of mass. */
static bool turns_about(struct wall_free *free, const char *name, const double gyration[9],
                        struct error *error) {
    const double *n = free->options.direction;
    struct law_vector arm = law_add(free->rest, -1.0, wall_vector(free->options.point));
    if (isnan(gyration[0]))
        return refuse(name, no_inertia, error);
    arm = law_project(arm, wall_vector(n));
    double own = law_dot(arm, arm);
    for (int d = 0; d < 3; d++)
        for (int e = 0; e < 3; e++)
            own += n[d] * gyration[3 * d + e] * n[e];
    for (int d = 0; d < 3; d++)
        free->inertia[d] = free->mass * own;
    return own > 0.0 || refuse(name, "it has no inertia about its axis; give its inertia", error);
}

/* Takes the options, in box-relative coordinates. */
static bool free_options(struct wall_free *free, const struct box *box, const char *name,
                         struct error *error) {
    struct wall_free_options *options = &free->options;
    struct law_vector direction = wall_vector(options->direction), point = box_place(options->point, box);
    bool directed = options->freedom == WALL_FREE_ALONG || options->freedom == WALL_FREE_ABOUT;
    double length = length_of(direction);
    memcpy(options->point, &point, sizeof options->point);
    if (!directed)
        return true;
    if (!(length > 0.0 && isfinite(length)))
        return refuse(name, "its direction has no length", error);
    for (int d = 0; d < 3; d++)
        options->direction[d] /= length;
    return true;
}

bool wall_free_create(struct wall_free **made, const struct wall_options *options,
                      const struct wall_mesh *mesh, const struct box *box, struct error *error) {
    struct wall_free *free = *made = memory_allocate_zero(1, sizeof *free, "free wall");
    struct form form;
    *free = (struct wall_free){.options = options->free, .flat = box->dimension == 2, .axes_rest = {1.0}};
    form_make(&form, options, mesh, box);
    bool given = free->options.mass > 0.0;
    free->mass = given ? free->options.mass : free->options.density * form.moments.volume;
    form_take(&form, &free->options, free->mass, box);
    free->rest = wall_vector(form.moments.centre);
    free->extent = form.extent;
    bool good =
        (free->mass > 0.0 && isfinite(free->mass)) ||
        refuse(options->name, "the shape encloses no volume, which a density needs; give its mass", error);
    good = good && free_options(free, box, options->name, error);
    if (good && free->options.freedom == WALL_FREE_ALL)
        good = turns_all(free, options->name, form.moments.gyration, error);
    if (good && free->options.freedom == WALL_FREE_ABOUT)
        good = turns_about(free, options->name, form.moments.gyration, error);
    if (!good)
        wall_free_destroy(made);
    return good;
}

void wall_free_destroy(struct wall_free **free) {
    memory_free(*free);
    *free = NULL;
}
