/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls that cannot be: their places in a periodic box, their motions, free ones, fields, and names. */
#include "data/scene/scene_check.h"

#include <math.h>
#include <string.h>

/* Largest rounding error of a component of a unit vector that is meant to be 0. */
static const double rounding = 1e-12;

static bool check_periodic_plane(const struct scene *scene, int w, int d, struct error *error) {
    char key[80];
    snprintf(key, sizeof(key), "walls[%d].normal", w);
    return scene->wall[w].normal[d] == 0 ||
           scene_fail(
               scene, error, key,
               "the plane crosses the periodic direction %c; its normal must have no component along it",
               "xyz"[d]);
}

/* Along a periodic direction a cylinder goes on in its images; across it, it must end where the box does, and
 * so must a slanting one that is felt from inside: particles in it would be outside of its images. */
static bool check_periodic_cylinder(const struct scene *scene, int w, int d, struct error *error) {
    const struct wall_options *wall = &scene->wall[w];
    double along = fabs(wall->axis[d]), across = hypot(wall->axis[(d + 1) % 3], wall->axis[(d + 2) % 3]);
    char key[80];
    if (across <= rounding)
        return true;
    snprintf(key, sizeof(key), "walls[%d].axis", w);
    if (wall->length == 0 && along > rounding)
        return scene_fail(scene, error, key,
                          "the endless cylinder slants across the periodic direction %c, where it would not "
                          "meet its images; allowed: an axis along %c, or without a component along it",
                          "xyz"[d], "xyz"[d]);
    double girth = wall->radius * sqrt(fmax(0, 1 - along * along));
    double reach = girth + (wall->inside ? along * wall->length / 2 : 0);
    double lower = scene->box_lower[d], upper = scene->box_upper[d], middle = wall->point[d];
    bool wide = middle - girth < lower || middle + girth > upper;
    snprintf(key, sizeof(key), "walls[%d].%s", w, wide ? "radius" : "length");
    return (middle - reach >= lower && middle + reach <= upper) ||
           scene_fail(scene, error, key,
                      "the cylinder crosses the ends of the periodic direction %c (%g to %g)", "xyz"[d],
                      lower, upper);
}

/* Walls that a periodic direction would have to repeat. */
static bool check_periodic(const struct scene *scene, struct error *error) {
    for (int w = 0; w < scene->walls; w++)
        for (int d = 0; d < 3; d++) {
            enum wall_shape shape = scene->wall[w].shape;
            if (!scene->box.periodic[d])
                continue;
            if ((shape == WALL_PLANE && !check_periodic_plane(scene, w, d, error)) ||
                (shape == WALL_CYLINDER && !check_periodic_cylinder(scene, w, d, error)))
                return false;
        }
    return true;
}

/* True if the area on which a pressure acts follows from the wall's shape (walls_area). */
static bool has_area(const struct scene *scene, int w) {
    const struct wall_options *wall = &scene->wall[w];
    bool across = false;
    for (int d = 0; d < scene->box.dimension; d++)
        across = across || fabs(wall->normal[d]) == 1;
    return wall_shape_meshed(wall->shape) ? scene->box.dimension == 3 : wall->shape == WALL_PLANE && across;
}

/* The target of a servo. */
static bool check_target(const struct scene *scene, int w, int m, struct error *error) {
    const struct wall_motion *motion = &scene->wall[w].motion[m];
    bool pressure = !isnan(motion->pressure), area = !isnan(motion->area);
    char key[80];
    snprintf(key, sizeof(key), "walls[%d].motion[%d].%s", w, m,
             area       ? "area"
             : pressure ? "pressure"
                        : "kind");
    if (pressure != isnan(motion->force))
        return scene_fail(scene, error, key, "a servo needs either a force or a pressure");
    if (area && !pressure)
        return scene_fail(scene, error, key, "goes with a pressure; the target is a force");
    return !pressure || area || has_area(scene, w) ||
           scene_fail(scene, error, key,
                      "needs an area, as none follows from the shape of the wall: allowed without one are "
                      "planes across an edge of the box, and meshes in three dimensions");
}

static bool check_motions(const struct scene *scene, struct error *error) {
    for (int w = 0; w < scene->walls; w++) {
        int servos = 0;
        for (int m = 0; m < scene->wall[w].motions; m++) {
            const struct wall_motion *motion = &scene->wall[w].motion[m];
            char key[80];
            snprintf(key, sizeof(key), "walls[%d].motion[%d].stop", w, m);
            if (!(motion->stop > motion->start))
                return scene_fail(scene, error, key, "%g is not after start (%g)", motion->stop,
                                  motion->start);
            snprintf(key, sizeof(key), "walls[%d].motion[%d].kind", w, m);
            servos += motion->kind == WALL_SERVO;
            if (servos > 1)
                return scene_fail(scene, error, key, "a second servo; a wall can follow one force only");
            if (motion->kind == WALL_SERVO && !check_target(scene, w, m, error))
                return false;
        }
    }
    return true;
}

/* True if a wall may leave its place across a periodic direction: one without images there would not come back. */
static bool crosses(const struct scene *scene, const struct wall_options *wall) {
    bool crosses = false;
    for (int d = 0; d < 3; d++) {
        bool across = scene->box.periodic[d] && fabs(wall->axis[d]) <= rounding;
        crosses =
            crosses ||
            (across && (wall->free.freedom == WALL_FREE_SHIFT || fabs(wall->free.direction[d]) > rounding));
    }
    return crosses;
}

/* What a shape without a middle may do. */
static bool check_endless(const struct scene *scene, int w, struct error *error) {
    const struct wall_options *wall = &scene->wall[w];
    char key[80];
    snprintf(key, sizeof(key), "walls[%d].free.freedom", w);
    if (wall->shape == WALL_PLANE)
        return wall->free.freedom == WALL_FREE_ALONG || wall->free.freedom == WALL_FREE_SHIFT ||
               scene_fail(scene, error, key,
                          "a plane has no middle about which it could turn; allowed: along, shift");
    if (wall->shape != WALL_CYLINDER || wall->length > 0)
        return true;
    if (wall->free.freedom == WALL_FREE_ALL)
        return scene_fail(
            scene, error, key,
            "an endless cylinder has no middle about which it could turn; allowed: along, shift, about, or "
            "a length");
    if (wall->free.freedom == WALL_FREE_ABOUT) {
        snprintf(key, sizeof(key), "walls[%d].free.inertia", w);
        return wall->free.inertia_given ||
               scene_fail(scene, error, key, "is missing: none follows from an endless cylinder");
    }
    return !crosses(scene, wall) || scene_fail(scene, error, key,
                                               "an endless cylinder cannot move across a periodic direction; "
                                               "allowed: along another direction, "
                                               "about, or a length");
}

/* What a free wall is given. */
static bool check_free(const struct scene *scene, int w, struct error *error) {
    const struct wall_options *wall = &scene->wall[w];
    const struct wall_free_options *free = &wall->free;
    bool turns = free->freedom == WALL_FREE_ALL || free->freedom == WALL_FREE_ABOUT;
    char key[80];
    snprintf(key, sizeof(key), "walls[%d].motion", w);
    if (wall->motions > 0)
        return scene_fail(scene, error, key,
                          "a wall either moves by order or is free; take out motion or free");
    snprintf(key, sizeof(key), "walls[%d].free.%s", w, isnan(free->density) ? "mass" : "density");
    if (isnan(free->mass) == isnan(free->density))
        return scene_fail(scene, error, key, "a free wall needs either a mass or a density");
    snprintf(key, sizeof(key), "walls[%d].free.centre", w);
    if (free->centre_given != 0 && free->centre_given != 3)
        return scene_fail(scene, error, key, "needs three numbers");
    if (free->centre_given && turns && !free->inertia_given)
        return scene_fail(scene, error, key, "needs inertia, too: about this centre");
    snprintf(key, sizeof(key), "walls[%d].free.velocity", w);
    if (free->velocity_given == 1)
        return scene_fail(scene, error, key, "needs three numbers, or two");
    snprintf(key, sizeof(key), "walls[%d].free.angular_velocity", w);
    if (free->omega_given != 0 && free->omega_given != 3)
        return scene_fail(scene, error, key, "needs three numbers");
    snprintf(key, sizeof(key), "walls[%d].free.inertia", w);
    if (free->inertia_given != 0 && free->inertia_given != 6)
        return scene_fail(scene, error, key, "needs six numbers: xx yy zz xy xz yz");
    return check_endless(scene, w, error);
}

static bool check_all_free(const struct scene *scene, struct error *error) {
    for (int w = 0; w < scene->walls; w++)
        if (scene->wall[w].free.given && !check_free(scene, w, error))
            return false;
    return true;
}

/* A checkpoint keeps numbers of walls that are free, beside a fluid, or whose surfaces move, under a word of up to eight letters and the name. */
static bool check_names(const struct scene *scene, struct error *error) {
    const size_t most = OUTPUT_NAME_MAX - sizeof "surface ";
    for (int w = 0; w < scene->walls; w++) {
        const struct wall_options *wall = &scene->wall[w];
        bool kept = wall->free.given || scene->physics_given[PHYSICS_fluid];
        char key[80];
        for (int m = 0; m < wall->motions; m++)
            kept = kept || wall->motion[m].surface;
        snprintf(key, sizeof(key), "walls[%d].name", w);
        if (kept && strlen(wall->name) > most)
            return scene_fail(scene, error, key,
                              "longer than %zu bytes, which those of walls that are free, beside a fluid, "
                              "or whose surfaces move, may have",
                              most);
    }
    return true;
}

static bool check_fields(const struct scene *scene, struct error *error) {
    for (int w = 0; w < scene->walls; w++) {
        const struct wall_options *wall = &scene->wall[w];
        char key[80];
        if (wall->shape != WALL_MESH)
            continue;
        snprintf(key, sizeof(key), "walls[%d].field_spacing", w);
        if (!wall->field && !isnan(wall->field_spacing))
            return scene_fail(scene, error, key, "is that of a field; needs field: true");
        snprintf(key, sizeof(key), "walls[%d].field", w);
        if (wall->field && scene->box.dimension == 2)
            return scene_fail(scene, error, key, "needs three dimensions; allowed in two: false");
    }
    return true;
}

bool scene_check_walls(const struct scene *scene, struct error *error) {
    return check_periodic(scene, error) && check_motions(scene, error) && check_all_free(scene, error) &&
           check_names(scene, error) && check_fields(scene, error);
}
