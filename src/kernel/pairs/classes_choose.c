/* SPDX-License-Identifier: BSD-3-Clause */
/* Chooses the cuts between size classes. Read classes_choose.h first. */
#include "kernel/pairs/classes_choose.h"
#include "base/memory.h"
#include "index/choose/auto_choose.h"
#include <math.h>
#include <stdlib.h>

/* CLASSES_AUTO: the density matters little, and of a bed in a large box only the box is known; so it is taken
 * to be within these bounds. */
static const double fraction_least = 0.1, fraction_most = 0.64, fraction_unknown = 0.5;

static int compare_radii(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Geometric cuts: `count` classes between the smallest and the largest radius. */
static void cuts_geometric(struct size_classes *classes, int count, double smallest, double largest) {
    double ratio = pow(largest / smallest, 1.0 / count);
    classes->count = count;
    for (int c = 0; c < count - 1; c++)
        classes->cut[c] = smallest * pow(ratio, c + 1);
    classes->cut[count - 1] = INFINITY;
}

static void cuts_quantiles(struct size_classes *classes, int count, const double *radii, size_t n) {
    classes->count = 0;
    for (int c = 0; c < count - 1; c++) {
        double cut = radii[(size_t)((double)(c + 1) / count * (double)(n - 1))];
        if (classes->count == 0 || cut > classes->cut[classes->count - 1])
            classes->cut[classes->count++] = cut;
    }
    classes->cut[classes->count++] = INFINITY;
}

static bool cuts_given(struct size_classes *classes, const struct classes_options *options,
                       struct error *error) {
    for (int c = 0; c < options->cut_count; c++) {
        double before = c > 0 ? options->cut[c - 1] : 0;
        if (!(options->cut[c] > before))
            return error_set(error, ERROR_USER,
                             "classes.cuts: cut %d is %g, after %g: cuts must be positive and increasing",
                             c + 1, options->cut[c], before);
        classes->cut[c] = options->cut[c];
    }
    classes->count = options->cut_count + 1;
    classes->cut[options->cut_count] = INFINITY;
    return true;
}

/* Cuts as the cost model of the index has them best. Radii are sorted. */
static void cuts_auto(struct size_classes *classes, const struct classes_options *options,
                      const struct classes_range *range, const double *radii, size_t n) {
    struct cost_scene *scene = memory_allocate_zero(1, sizeof *scene, "radius histogram");
    struct cost_plan plan = {.levels = 1};
    double fraction = options->fraction > 0 ? options->fraction : fraction_unknown;
    double weight = options->particles > 0 ? options->particles / (double)n : 1;
    scene->dimension = options->dimension == 2 ? 2 : 3;
    for (size_t k = 0; k < n; k++)
        scene->volume += scene->dimension == 2 ? M_PI * radii[k] * radii[k]
                                               : 4 * M_PI / 3 * radii[k] * radii[k] * radii[k];
    scene->volume *= weight / fmin(fmax(fraction, fraction_least), fraction_most);
    auto_bins(scene, radii, n, weight);
    for (int bin = 0; bin < scene->bins; bin++) {
        double radius = scene->radius_min[bin];
        double skin = options->skin_given ? options->skin : options->skin_relative * radius;
        scene->margin[bin] =
            fmax(classes_range_at(range, options->kind, radius, options->kind, radius), 0) + skin;
    }
    auto_levels(scene, CLASS_MAX, &plan);
    classes->count = plan.levels;
    for (int c = 0; c < plan.levels; c++)
        classes->cut[c] = scene->radius_max[plan.last[c]];
    classes->cut[plan.levels - 1] = INFINITY;
    memory_free(scene);
}

/* Radii, sorted, give each class its smallest and largest one; classes without a radius are removed. */
static void classes_fill(struct size_classes *classes, const double *radii, size_t n) {
    int kept = 0;
    size_t k = 0;
    for (int c = 0; c < classes->count; c++) {
        size_t first = k;
        while (k < n && radii[k] <= classes->cut[c])
            k++;
        if (k == first)
            continue;
        classes->cut[kept] = classes->cut[c];
        classes->radius_min[kept] = radii[first];
        classes->radius_max[kept] = radii[k - 1];
        classes->population[kept] = k - first;
        kept++;
    }
    classes->count = kept;
    classes->cut[kept - 1] = INFINITY;
}

bool classes_choose(struct size_classes *classes, const struct classes_options *options,
                    const struct classes_range *range, double *radii, size_t n, struct error *error) {
    *classes = (struct size_classes){.count = 1, .cut = {INFINITY}};
    if (n == 0) {
        classes_set_margins(classes, options, range);
        return true;
    }
    qsort(radii, n, sizeof *radii, compare_radii);
    double smallest = radii[0], largest = radii[n - 1];
    int wanted = options->count < 1 ? 1 : options->count > CLASS_MAX ? CLASS_MAX : options->count;
    if (options->method == CLASSES_CUTS) {
        if (!cuts_given(classes, options, error))
            return false;
    } else if (options->method == CLASSES_QUANTILES) {
        cuts_quantiles(classes, wanted, radii, n);
    } else if (options->method == CLASSES_AUTO && smallest > 0) {
        cuts_auto(classes, options, range, radii, n);
    } else if (options->method == CLASSES_GEOMETRIC) {
        cuts_geometric(classes, wanted, smallest, largest);
    }
    classes_fill(classes, radii, n);
    classes_set_margins(classes, options, range);
    return true;
}
