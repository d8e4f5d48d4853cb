/* SPDX-License-Identifier: BSD-3-Clause */
/* Height and solid fraction of a bed. Read bed.h first. */
#include "pack/bed.h"
#include "pack/container.h"

#include <math.h>

enum { POINTS = 200000, HALVINGS = 60 };

static const double part = 0.75;

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

bool bed_measure(struct pack_bed *bed, const struct pack_options *options, const struct rows *rows,
                 struct error *error) {
    struct pack_container container;
    struct random_sequence random = random_sequence((uint64_t)options->seed, RANDOM_POSITION, 0);
    double solid = solid_below(rows, INFINITY), x[3];
    int below = 0;
    bool good = container_create(&container, options, solid, error);
    bed->height = height_of(rows, part * solid) - rows->lower[2];
    for (int k = 0; good && k < POINTS; k++)
        below += container_draw(&container, 0, &random, x) && x[2] < bed->height;
    if (good)
        bed->fraction = part * solid / (container.volume * below / POINTS);
    container_free(&container);
    return good;
}
