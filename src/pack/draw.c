/* SPDX-License-Identifier: BSD-3-Clause */
/* Draws radii from a law of sizes. Read draw.h first. */
#include "pack/draw.h"

#include "core/random.h"
#include "files/lines.h"
#include "scene/sizes.h"

#include <math.h>

/* Dunkirk sand in micrometres, see the law's help. */
static const double sand_min = 2, sand_max = 925;
static const struct sizes_options sand_sharp = {
    .law = SIZES_LOGNORMAL, .min = 2, .max = 925, .mean = 2.55, .width = 0.15};
static const struct sizes_options sand_broad = {
    .law = SIZES_LOGNORMAL, .min = 2, .max = 925, .mean = 320, .width = 0.35};

struct drawing {
    const struct pack_options *options;
    struct sizes_sampler sampler, broad; /* broad: SAND's second peak */
};

static double draw_sand(const struct drawing *drawing, struct random_sequence *random) {
    const struct pack_options *o = drawing->options;
    bool broad = random_uniform(random) < o->broad;
    double diameter = sizes_draw(broad ? &drawing->broad : &drawing->sampler, random);
    return (1 + (diameter - sand_min) / (sand_max - sand_min) * (o->ratio - 1)) / 2;
}

/* By number the law is inverted; by mass the number density is d^-3 exp(-d / scale): drawn from the power and
 * accepted with the exponential. */
static double draw_exponential(const struct drawing *drawing, struct random_sequence *random) {
    const struct pack_options *o = drawing->options;
    if (o->by == PACK_BY_NUMBER)
        return (1 - o->scale * log1p(random_uniform(random) * expm1(-(o->ratio - 1) / o->scale))) / 2;
    for (;;) {
        double r = sizes_draw(&drawing->sampler, random);
        if (random_uniform(random) < exp(-(2 * r - 1) / o->scale))
            return r;
    }
}

static double draw_one(const struct drawing *drawing, uint64_t number) {
    struct random_sequence random = random_sequence((uint64_t)drawing->options->seed, RANDOM_RADIUS, number);
    if (drawing->options->law == PACK_SAND)
        return draw_sand(drawing, &random);
    if (drawing->options->law == PACK_EXPONENTIAL)
        return draw_exponential(drawing, &random);
    return sizes_draw(&drawing->sampler, &random);
}

/* Reads openings and passing percentages; diameters become radii, percent become parts. */
static bool read_sieves(const struct pack_options *options, struct sizes_options *sizes,
                        struct error *error) {
    struct lines lines;
    double value[3];
    bool good = true;
    if (!lines_open(&lines, options->table, error))
        return false;
    while (good && lines_next_filled(&lines)) {
        int n = lines_numbers(&lines, value, 3);
        if (n != 2)
            good = lines_refuse(&lines, error, "must hold two numbers: a sieve's opening and what passes");
        else if (!(value[0] > 0))
            good = lines_refuse(&lines, error, "a sieve's opening must be positive");
        else if (sizes->points == SIZES_POINTS_MAX)
            good = lines_refuse(&lines, error, "is one sieve too many: %d are allowed", SIZES_POINTS_MAX);
        if (!good)
            break;
        sizes->radii[sizes->points] = value[0] / 2;
        sizes->share[sizes->points++] = value[1];
    }
    if (good && lines.damaged)
        good = lines_refuse(&lines, error, "the file does not end here");
    lines_close(&lines);
    sizes->values = sizes->points;
    bool percent = sizes->points > 0 && sizes->share[sizes->points - 1] == 100;
    for (int k = 0; percent && k < sizes->points; k++)
        sizes->share[k] /= 100;
    return good;
}

static bool prepare(struct drawing *drawing, struct error *error) {
    const struct pack_options *o = drawing->options;
    struct sizes_options sizes = {.law = SIZES_POWER, .min = o->min, .max = o->max, .exponent = o->exponent};
    struct error why = {0};
    if (o->law == PACK_SAND)
        return sizes_prepare(&drawing->sampler, &sand_sharp, error) &&
               sizes_prepare(&drawing->broad, &sand_broad, error);
    if (o->law == PACK_UNIVOL || o->law == PACK_EXPONENTIAL) {
        sizes.exponent = -3;
        sizes.min = o->law == PACK_UNIVOL ? 1 : 0.5;
        sizes.max = sizes.min * o->ratio;
    }
    if (o->law == PACK_SIEVE) {
        sizes = (struct sizes_options){.law = SIZES_TABLE,
                                       .by = o->by == PACK_BY_MASS ? SIZES_BY_MASS : SIZES_BY_NUMBER};
        if (!read_sieves(o, &sizes, error))
            return false;
        if (!sizes_prepare(&drawing->sampler, &sizes, &why))
            return error_set(error, ERROR_USER, "%s: %s", o->table, why.text);
        return sizes.radii[sizes.points - 1] <= 1000 * sizes.radii[0] ||
               error_set(error, ERROR_USER, "%s: the largest opening is more than 1000 times the smallest",
                         o->table);
    }
    return sizes_prepare(&drawing->sampler, &sizes, error);
}

bool draw_radii(const struct pack_options *options, double *radius, size_t count, struct error *error) {
    struct drawing drawing = {.options = options};
    if (!prepare(&drawing, error))
        return false;
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < count; k++)
        radius[k] = draw_one(&drawing, k);
    return true;
}
