/* SPDX-License-Identifier: BSD-3-Clause */
/* Height and solid fraction of a bed. Read bed.h first. */
#include "front/pack/bed.h"
#include "front/pack/container.h"

#include <math.h>

enum { POINTS = 200000, HALVINGS = 60 };

static const double bed_part = 0.75;

/* The volume of the spheres below a height. */
static double solid_below(const struct rows *rows, double height) {
    double sum = 0;
    for (size_t k = 0; k < rows->count; k++) {
        double r = rows->radius[k];
        double cap = fmin(fmax(height - (rows->position[k][2] - r), 0), 2 * r);
        sum += M_PI * cap * cap * (r - cap / 3);
    }
    return sum;
}

/* The height below which this solid volume lies. */
static double height_of(const struct rows *rows, double solid) {
    double lower = rows->lower[2], upper = rows->upper[2];
    for (int k = 0; k < HALVINGS; k++) {
        double middle = 0.5 * (lower + upper);
        if (solid_below(rows, middle) < solid)
            lower = middle;
        else
            upper = middle;
    }
    return upper;
}

/* The part of a mesh below a height, from random points. */
static double mesh_below(const struct pack_container *container, double height, double seed) {
    struct random_sequence random = random_sequence((uint64_t)seed, RANDOM_POSITION, 0);
    double x[3];
    int below = 0;
    for (int k = 0; k < POINTS; k++)
        below += container_draw(container, 0, &random, x) && x[2] < height;
    return container->volume * below / POINTS;
}

/* The volume of the container below a height. */
static double volume_below(const struct pack_container *container, double height, double seed) {
    if (container->shape == PACK_MESH)
        return mesh_below(container, height, seed);
    if (container->shape == PACK_SPHERE)
        return M_PI * height * height * (container->radius - height / 3);
    return container->volume * height / container->box.edge[2];
}

bool bed_measure(struct pack_bed *bed, const struct pack_options *options, const struct rows *rows,
                 struct error *error) {
    struct pack_container container;
    double solid = solid_below(rows, INFINITY);
    bool good = container_create(&container, options, solid, error);
    bed->height = height_of(rows, bed_part * solid) - rows->lower[2];
    if (good)
        bed->fraction = bed_part * solid / volume_below(&container, bed->height, options->seed);
    container_free(&container);
    return good;
}
