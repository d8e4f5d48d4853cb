/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls that cannot be: their places in a periodic box, and their motions. */
#include "data/scene/scene_check.h"

#include <math.h>

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

bool scene_check_walls(const struct scene *scene, struct error *error) {
    return check_periodic(scene, error) && check_motions(scene, error);
}
