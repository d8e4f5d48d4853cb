/* SPDX-License-Identifier: BSD-3-Clause */
/* Laws of sizes that a scene does not have become sieve curves of 64 sieves. Read recipe_work.h first. */
#include "front/pack/recipe_work.h"

#include <math.h>
#include <string.h>

enum { SIEVES = 64 };

/* Dunkirk sand in micrometres, see the law's help. */
static const double sand_min = 2, sand_max = 925;
static const struct peak { double median, width; } sharp = {2.55, 0.15}, broad = {320, 0.35};
/* Half of the sieves of sand are spread over each peak, so many widths to either side. */
static const double peak_widths = 4;

/* Solid fractions of large and small spheres in the recipe of the bidisperse systems. */
static const double recipe_large = 0.12, recipe_small = 0.36;

/* A sieve curve by its openings and what passes, rising from 0 to 1. */
static void set_curve(struct recipe_work *work, const double *diameter, const double *passing) {
    char lists[2][SIEVES * 26] = {"", ""};
    for (int k = 0; k < SIEVES; k++) {
        const char *comma = k ? ", " : "";
        snprintf(lists[0] + strlen(lists[0]), sizeof lists[0] - strlen(lists[0]), "%s%.15g", comma,
                 diameter[k]);
        snprintf(lists[1] + strlen(lists[1]), sizeof lists[1] - strlen(lists[1]), "%s%.15g", comma,
                 passing[k]);
    }
    recipe_set(work, "particles.sources[0].sizes.law=table");
    recipe_set(work, "particles.sources[0].sizes.diameters=[%s]", lists[0]);
    recipe_set(work, "particles.sources[0].sizes.passing=[%s]", lists[1]);
}

/* Diameters from 1 to `ratio`, of which the part (1 - exp(-(d - 1) / scale)) passes, up to a factor. The sieves stand closest at 1. */
static void exponential(struct recipe_work *work, double ratio, double scale) {
    double diameter[SIEVES], passing[SIEVES], first = fmin(scale, 1);
    double step = log1p((ratio - 1) / first) / (SIEVES - 1);
    for (int k = 0; k < SIEVES; k++) {
        diameter[k] = k == SIEVES - 1 ? ratio : 1 + first * expm1(step * k);
        passing[k] = expm1(-(diameter[k] - 1) / scale) / expm1(-(ratio - 1) / scale);
    }
    passing[SIEVES - 1] = 1;
    set_curve(work, diameter, passing);
}

/* The part of a log-normal law, cut to the sizes of sand, below x. */
static double below(const struct peak *peak, double x) {
    double low = erf(log(sand_min / peak->median) / peak->width / M_SQRT2);
    double high = erf(log(sand_max / peak->median) / peak->width / M_SQRT2);
    return (erf(log(x / peak->median) / peak->width / M_SQRT2) - low) / (high - low);
}

static void sand(struct recipe_work *work, double ratio) {
    enum { HALF = SIEVES / 2 };
    double diameter[SIEVES], passing[SIEVES];
    for (int k = 0; k < SIEVES; k++) {
        const struct peak *peak = k < HALF ? &sharp : &broad;
        double low = fmax(sand_min, peak->median * exp(-peak_widths * peak->width));
        double high = fmin(sand_max, peak->median * exp(peak_widths * peak->width));
        double x = low * pow(high / low, (double)(k % HALF) / (HALF - 1));
        diameter[k] = 1 + (x - sand_min) / (sand_max - sand_min) * (ratio - 1);
        passing[k] = (1 - work->broad) * below(&sharp, x) + work->broad * below(&broad, x);
    }
    diameter[SIEVES - 1] = ratio;
    passing[0] = 0;
    passing[SIEVES - 1] = 1;
    set_curve(work, diameter, passing);
}

bool recipe_sizes(struct recipe_work *work) {
    const char *law = work->law->name;
    double ratio, scale;
    if (!recipe_number(work, "ratio", 1.001, 1000, &ratio) ||
        !recipe_number(work, "scale", 0.01, 1e6, &scale) || !recipe_number(work, "broad", 0, 1, &work->broad))
        return false;
    if (strcmp(law, "sand") == 0) {
        sand(work, ratio);
        recipe_set(work, "particles.sources[0].sizes.by=number");
    } else if (strcmp(law, "exponential") == 0) {
        exponential(work, ratio, scale);
    } else if (strcmp(law, "sieve") == 0) {
        recipe_set(work, "particles.sources[0].sizes.law=table");
    } else {
        recipe_set(work, "particles.sources[0].sizes.law=%s", strcmp(law, "univol") == 0 ? "power" : law);
    }
    if (strcmp(law, "univol") == 0) {
        recipe_set(work, "particles.sources[0].sizes.min=1");
        recipe_set(work, "particles.sources[0].sizes.max=%.17g", ratio);
        recipe_set(work, "particles.sources[0].sizes.exponent=-3");
    }
    return true;
}

/* A published system. */
struct published {
    const char *law;
    double ratio, box, large, small; /* small: all, where there is one kind */
};

/* Stratford, Shire and Hanley: Table 1, and the continuous distributions. */
static const struct published systems[] = {{"bidisperse", 10, 205.9, 250, 711657},
                                           {"bidisperse", 20, 314.15, 111, 2337678},
                                           {"bidisperse", 40, 500.14, 56, 9624306},
                                           {"bidisperse", 80, 793.92, 28, 42900051},
                                           {"bidisperse", 100, 955.61, 25, 66193461},
                                           {"sand", 10, 205.9, 0, 712333},
                                           {"sand", 20, 506, 0, 2336380},
                                           {"sand", 40, 1475, 0, 9591137},
                                           {"exponential", 50, 368.77, 0, 5040560}};

static const struct published *find(const struct recipe_work *work, double ratio) {
    for (size_t k = 0; k < sizeof systems / sizeof systems[0]; k++)
        if (strcmp(systems[k].law, work->law->name) == 0 && systems[k].ratio == ratio)
            return &systems[k];
    return NULL;
}

bool recipe_published(struct recipe_work *work) {
    bool has = strcmp(work->law->name, "sand") == 0 || strcmp(work->law->name, "exponential") == 0;
    double ratio, count;
    if (!has)
        return true;
    if (!recipe_number(work, "ratio", 1.001, 1000, &ratio) || !recipe_whole(work, "count", 1, &count))
        return false;
    const struct published *system = find(work, ratio);
    work->count = count > 0 ? count : system ? system->small : 0;
    if (work->count == 0)
        return recipe_fail(work, "ratio=%g is not a published system: give count, and box or fraction",
                           ratio);
    bool free = !recipe_given(work, "box") && !recipe_given(work, "fraction");
    if (free && !system)
        return recipe_fail(work, "ratio=%g is not a published system: give box or fraction", ratio);
    if (free)
        work->box = system->box * cbrt(work->count / system->small);
    return true;
}

/* Numbers and box: those of the table, or the user's own. */
static bool read_numbers(struct recipe_work *work, double ratio, double *large, double *small) {
    const struct published *system = find(work, ratio);
    double box;
    if (!recipe_number(work, "box", 1e-9, 1e9, &box) || !recipe_whole(work, "large", 0, large) ||
        !recipe_whole(work, "small", 1, small))
        return false;
    bool own = box > 0 || *large > 0 || *small > 0;
    if (!own && !system)
        return recipe_fail(work,
                           "ratio=%g is not in the published table (10, 20, 40, 80, 100): give box, large "
                           "and small, or box and numbers=recipe",
                           ratio);
    if (!own) {
        box = system->box;
        *large = system->large;
        *small = system->small;
    }
    work->box = box;
    return box > 0 || recipe_fail(work, "large and small need a box");
}

bool recipe_bidisperse(struct recipe_work *work) {
    const char *text = recipe_value(work, "numbers");
    bool recipe = strcmp(text, "recipe") == 0;
    double ratio, large, small;
    if (!recipe && strcmp(text, "table") != 0)
        return recipe_fail(work, "numbers=%s: allowed are table, recipe", text);
    if (!recipe_number(work, "ratio", 1.001, 1000, &ratio) || !read_numbers(work, ratio, &large, &small))
        return false;
    bool own = recipe_given(work, "large") && large > 0;
    if (recipe && !own)
        large = rint(recipe_large * pow(work->box / ratio, 3) * 0.75 / M_PI);
    if (!recipe && small <= 0)
        return recipe_fail(work, "a box needs small (and large), or numbers=recipe");
    for (int s = large > 0 ? 0 : 1; s < 2; s++) {
        int at = work->sources++;
        recipe_set(work, "particles.sources[%d].from=packed", at);
        recipe_set(work, "particles.sources[%d].material=%s", at, s ? "small" : "large");
        recipe_set(work, "particles.sources[%d].sizes=%.17g", at, s ? 1 : ratio);
        if (s == 0 || !recipe)
            recipe_set(work, "particles.sources[%d].count=%.0f", at, s ? small : large);
        else
            recipe_set(work, "particles.sources[%d].volume_fraction=%g", at, recipe_small);
        if (s == 1)
            recipe_set(work, "particles.sources[%d].meets=yield", at);
    }
    return true;
}
