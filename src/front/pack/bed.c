/* SPDX-License-Identifier: BSD-3-Clause */
/* Height and solid fraction of a bed. Read pack.h first. */
#include "front/pack/pack.h"
#include "base/random.h"

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

/* The volume of the region below a height, which counts from the lowest point of the rows' box. */
static double volume_below(const struct region *region, const struct region_space *space,
                           const struct rows *rows, double height) {
    struct random_sequence random = random_sequence(1, RANDOM_POSITION, 0);
    double x[3], volume = region_volume(region, space);
    int below = 0;
    if (region->shape == REGION_BOX)
        return volume * height / (region->upper[2] - region->lower[2]);
    for (int k = 0; k < POINTS; k++)
        below += region_draw(region, space, 0, &random, x) && x[2] - rows->lower[2] < height;
    return volume * below / POINTS;
}

struct bed bed_measure(const struct region *region, const struct region_space *space,
                       const struct rows *rows) {
    double solid = solid_below(rows, INFINITY);
    struct bed bed = {.height = height_of(rows, bed_part * solid) - rows->lower[2]};
    bed.fraction = bed_part * solid / volume_below(region, space, rows, bed.height);
    return bed;
}
