/* SPDX-License-Identifier: BSD-3-Clause */
/* Regions: test of a point, bounds and volumes, random points. Read region.h first. */
#include "data/scene/region.h"
#include "base/vector.h"

#include <math.h>
#include <string.h>

bool region_contains(const struct region *region, const struct region_space *space, const double x[3],
                     double margin) {
    double d[3] = {x[0] - region->centre[0], x[1] - region->centre[1], x[2] - region->centre[2]};
    if (space->dimension == 2)
        d[2] = 0;
    double along = vector_dot(d, region->axis);
    double room = region->radius - margin;
    switch (region->shape) {
    case REGION_ALL:
        return true;
    case REGION_BOX:
        for (int k = 0; k < space->dimension; k++) {
            double gap = space->wrap[k] ? 0 : margin;
            if (!(x[k] >= region->lower[k] + gap &&
                  (gap > 0 ? x[k] <= region->upper[k] - gap : x[k] < region->upper[k])))
                return false;
        }
        return true;
    case REGION_SPHERE:
        return room >= 0 && vector_dot(d, d) <= room * room;
    case REGION_SURFACE: {
        double depth = region->surface->depth(region->surface->context, x);
        return depth > 0 && depth >= margin;
    }
    default:
        if (space->dimension == 3 && fabs(along) > region->length / 2 - margin)
            return false;
        return room >= 0 && vector_dot(d, d) - along * along <= room * room;
    }
}

void region_bounds(const struct region *region, double lower[3], double upper[3]) {
    if (region->shape == REGION_SURFACE) {
        memcpy(lower, region->surface->lower, 3 * sizeof *lower);
        memcpy(upper, region->surface->upper, 3 * sizeof *upper);
        return;
    }
    for (int k = 0; k < 3; k++) {
        double half = region->radius;
        if (region->shape == REGION_CYLINDER)
            half = fabs(region->axis[k]) * region->length / 2 +
                   region->radius * sqrt(fmax(0, 1 - region->axis[k] * region->axis[k]));
        bool box = region->shape == REGION_BOX;
        lower[k] = box                           ? region->lower[k]
                   : region->shape == REGION_ALL ? -INFINITY
                                                 : region->centre[k] - half;
        upper[k] = box ? region->upper[k] : region->shape == REGION_ALL ? INFINITY : region->centre[k] + half;
    }
}

double region_volume(const struct region *region, const struct region_space *space) {
    double volume = 1, r = region->radius;
    switch (region->shape) {
    case REGION_ALL:
        return INFINITY;
    case REGION_BOX:
        for (int k = 0; k < space->dimension; k++)
            volume *= region->upper[k] - region->lower[k];
        return volume;
    case REGION_SPHERE:
        return space->dimension == 2 ? M_PI * r * r : 4 * M_PI / 3 * r * r * r;
    case REGION_SURFACE:
        return region->surface->volume;
    default:
        return M_PI * r * r * (space->dimension == 2 ? 1 : region->length);
    }
}

double region_inradius(const struct region *region, const struct region_space *space) {
    double radius = INFINITY, lower[3], upper[3];
    switch (region->shape) {
    case REGION_ALL:
        return INFINITY;
    case REGION_BOX:
        for (int k = 0; k < space->dimension; k++)
            if (!space->wrap[k])
                radius = fmin(radius, (region->upper[k] - region->lower[k]) / 2);
        return radius;
    case REGION_SPHERE:
        return region->radius;
    case REGION_SURFACE: /* a bound: that of the box around it */
        region_bounds(region, lower, upper);
        for (int k = 0; k < 3; k++)
            radius = fmin(radius, (upper[k] - lower[k]) / 2);
        return radius;
    default:
        return space->dimension == 2 ? region->radius : fmin(region->radius, region->length / 2);
    }
}

bool region_draw(const struct region *region, const struct region_space *space, double margin,
                 struct random_sequence *random, double x[3]) {
    double lower[3], upper[3];
    region_bounds(region, lower, upper);
    for (int k = 0; k < 3; k++) {
        double gap = region->shape == REGION_BOX && space->wrap[k] ? 0 : margin;
        if (region->shape == REGION_CYLINDER && fabs(region->axis[k]) < 1)
            gap = margin < region->radius
                      ? 0
                      : margin; /* the corners of a slanting cylinder's box are cut off below */
        lower[k] += gap;
        upper[k] -= gap;
        if (k < space->dimension && !(upper[k] >= lower[k]))
            return false;
    }
    for (int attempt = 0; attempt < 1000; attempt++) {
        for (int k = 0; k < space->dimension; k++)
            x[k] = lower[k] + random_uniform(random) * (upper[k] - lower[k]);
        if (space->dimension == 2)
            x[2] = space->plane;
        if (region_contains(region, space, x, margin))
            return true;
    }
    return false;
}

/* Spheres and cylinders: what lies across the axis is shortened, then what lies along it. A sphere has no axis. */
static void hold_round(const struct region *region, const struct region_space *space, double margin,
                       double x[3]) {
    bool rod = region->shape == REGION_CYLINDER;
    double d[3], across[3], most = region->radius - margin;
    for (int k = 0; k < 3; k++)
        d[k] = k < space->dimension ? x[k] - region->centre[k] : 0;
    double along = rod ? vector_dot(d, region->axis) : 0, end = region->length / 2 - margin;
    for (int k = 0; k < 3; k++)
        across[k] = rod ? d[k] - along * region->axis[k] : d[k];
    double square = vector_dot(across, across), part = square > most * most ? most / sqrt(square) : 1;
    double held = rod && space->dimension == 3 ? fmax(fmin(along, end), -end) : along;
    for (int k = 0; k < space->dimension && (part < 1 || held != along); k++)
        x[k] = region->centre[k] + part * across[k] + (rod ? held * region->axis[k] : 0);
}

void region_hold(const struct region *region, const struct region_space *space, const double from[3],
                 double margin, double x[3]) {
    switch (region->shape) {
    case REGION_ALL:
        return;
    case REGION_BOX:
        for (int k = 0; k < space->dimension; k++)
            if (!space->wrap[k])
                x[k] = fmin(fmax(x[k], region->lower[k] + margin), region->upper[k] - margin);
        return;
    case REGION_SURFACE:
        region->surface->hold(region->surface->context, from, margin, x);
        return;
    default:
        hold_round(region, space, margin, x);
    }
}
