/* SPDX-License-Identifier: BSD-3-Clause */
/* The point of a one-sided wall nearest to a place, for other physics than contacts. Read wall.h first. */
#include "walls/walls_touch.h"
#include <math.h>

static void put(double to[3], struct law_vector from) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

bool walls_one_sided(const struct walls *walls, int wall) {
    const struct wall_options *options = &walls->wall[wall].options;
    return options->shape == WALL_PLANE || (options->shape == WALL_CYLINDER && options->length == 0);
}

void walls_foot(const struct walls *walls, int wall, const double x[3], struct wall_foot *foot) {
    const struct wall *w = &walls->wall[wall];
    struct law_vector place = wall_vector(x), normal = w->axis_now;
    foot->distance = INFINITY;
    for (int k = 0; k < w->image_count; k++) {
        struct law_vector shift = walls_shift(walls, wall, w->image[k]), here = law_add(place, -1.0, shift);
        double distance = law_dot(w->axis_now, law_add(here, -1.0, w->point_now));
        if (w->options.shape == WALL_CYLINDER) {
            struct wall_cylinder cylinder = walls_cylinder(w);
            normal = law_scale(-1.0, wall_cylinder_toward(&cylinder, WALL_CYLINDER_SHELL, here, &distance));
        }
        if (!(distance < foot->distance))
            continue;
        foot->distance = distance;
        put(foot->normal, normal);
        put(foot->velocity, wall_twist_at(&w->twist, law_add(here, -distance, normal)));
    }
}
