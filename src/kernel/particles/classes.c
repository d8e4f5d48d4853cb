/* SPDX-License-Identifier: BSD-3-Clause */
/* Ranges, skins and margins of class pairs. Read classes.h first. */
#include "kernel/particles/classes.h"
#include <math.h>

struct classes_options classes_options_default(void) {
    return (struct classes_options){.method = CLASSES_AUTO, .count = 1, .skin_relative = 0.3};
}

double classes_range_at(const struct classes_range *range, int kind_a, double a, int kind_b, double b) {
    return range && range->of ? range->of(range->context, kind_a, a, kind_b, b) : 0;
}

/* The class of the smaller particles; walls are the largest. */
static int smaller_class(const struct size_classes *classes, int a, int b) {
    int low = a < b ? a : b, high = a < b ? b : a;
    if (high == classes->count || classes->kind[low] == classes->kind[high])
        return low;
    return classes->radius_min[low] <= classes->radius_min[high] ? low : high;
}

double classes_range_of(const struct size_classes *classes, const struct classes_range *range, int a, int b) {
    double most = -INFINITY;
    for (int end = 0; end < 4; end++) {
        double ra = end & 1 ? classes->radius_max[a] : classes->radius_min[a];
        double rb = b == classes->count ? INFINITY
                    : end & 2           ? classes->radius_max[b]
                                        : classes->radius_min[b];
        int kind_b = b == classes->count ? classes->kind[a] : classes->kind[b];
        most = fmax(most, classes_range_at(range, classes->kind[a], ra, kind_b, rb));
    }
    return most;
}

/* True if particles of neither class move: grains, kind 0, do, and others where the physics says so. */
static bool both_rest(const struct size_classes *classes, const struct classes_range *range, int a, int b) {
    unsigned moving = 1u | (range ? range->moving : 0);
    return a < classes->count && b < classes->count && !(moving >> classes->kind[a] & 1) &&
           !(moving >> classes->kind[b] & 1);
}

void classes_set_margins(struct size_classes *classes, const struct classes_options *options,
                         const struct classes_range *range) {
    int n = classes->count;
    for (int a = 0; a <= n; a++) {
        for (int b = 0; b <= n; b++) {
            int smaller = smaller_class(classes, a, b);
            double skin = both_rest(classes, range, a, b) ? 0
                          : options->skin_given           ? options->skin
                          : smaller < n ? options->skin_relative * classes->radius_min[smaller]
                                        : 0;
            classes->skin[a][b] = skin;
            double reach = a < n   ? classes_range_of(classes, range, a, b)
                           : b < n ? classes_range_of(classes, range, b, a)
                                   : 0;
            classes->margin[a][b] = reach + skin;
        }
    }
}
