/* SPDX-License-Identifier: BSD-3-Clause */
/* Draws radii from a law of sizes. Read draw.h first. */
#include "front/pack/draw.h"

#include "base/memory.h"
#include "base/random.h"
#include "kernel/particles/particles.h"
#include "data/scene/sizes_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

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

/* Reads a list of numbers, as in "1,2,4"; none if the text is NULL. */
static bool read_list(const char *text, double *value, int *count, struct error *error) {
    *count = 0;
    for (const char *at = text; at && *at; at += *at == ',') {
        char *end;
        double number = strtod(at, &end);
        if (end == at || (*end != ',' && *end != '\0') || !(number >= 0) || !isfinite(number))
            return error_set(error, ERROR_USER, "command line: '%s' must be a list of numbers, as in 1,2,4",
                             text);
        if (*count == SIZES_POINTS_MAX)
            return error_set(error, ERROR_USER, "command line: '%s' has more than %d numbers", text,
                             SIZES_POINTS_MAX);
        value[(*count)++] = number;
        at = end;
    }
    return true;
}

/* The sizes of the laws SIEVE and DISCRETE, from a file or from lists. */
static bool read_sizes(const struct pack_options *o, struct sizes_options *sizes, struct error *error) {
    struct error why = {0};
    bool in_file, discrete = o->law == PACK_DISCRETE;
    *sizes = (struct sizes_options){.law = discrete ? SIZES_DISCRETE : SIZES_TABLE,
                                    .by = o->by == PACK_BY_MASS ? SIZES_BY_MASS : SIZES_BY_NUMBER,
                                    .file_unit = 1};
    snprintf(sizes->file, sizeof sizes->file, "%s", o->table ? o->table : "");
    if (!read_list(o->radii, sizes->radii, &sizes->points, error) ||
        !read_list(o->diameters, sizes->diameter, &sizes->diameters, error) ||
        !read_list(discrete ? o->weights : o->passing, sizes->share, &sizes->values, error))
        return false;
    if (sizes_file_complete(sizes, &in_file, &why))
        return true;
    return error_set(error, ERROR_USER, "%s%s", in_file ? "" : "command line: ", why.text);
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
    if (o->law == PACK_SIEVE || o->law == PACK_DISCRETE) {
        const char *from = o->table ? o->table : "command line";
        double smallest, largest;
        if (!read_sizes(o, &sizes, error))
            return false;
        if (!sizes_prepare(&drawing->sampler, &sizes, &why))
            return error_set(error, ERROR_USER, "%s: %s", from, why.text);
        sizes_bounds(&sizes, &smallest, &largest);
        return (smallest > 0 && largest <= 1000 * smallest) ||
               error_set(error, ERROR_USER, "%s: the largest opening is more than 1000 times the smallest",
                         from);
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

/* The number of leading radii whose spheres come nearest to `solid`; 0 if all hold less. */
static size_t count_leading(const double *radius, size_t count, double solid) {
    double sum = 0;
    for (size_t k = 0; k < count; k++) {
        double more = particles_sphere_mass(radius[k], 1);
        if (sum + more >= solid)
            return solid - sum < sum + more - solid && k > 0 ? k : k + 1;
        sum += more;
    }
    return 0;
}

static double volume_of(const double *radius, size_t count) {
    double sum = 0;
    for (size_t k = 0; k < count; k++)
        sum += particles_sphere_mass(radius[k], 1);
    return sum;
}

double *draw_fill(const struct pack_options *options, double solid, size_t *count, struct error *error) {
    double *radius = NULL;
    bool good = true;
    *count = 0;
    for (size_t drawn = 1024; good && *count == 0 && drawn <= (size_t)1 << 27; drawn *= 2) {
        radius = memory_resize(radius, drawn, sizeof *radius, "radii");
        good = draw_radii(options, radius, drawn, error);
        *count = good ? count_leading(radius, drawn, solid) : 0;
        if (good && drawn == 1024 && *count == 0 && solid > 1e5 * volume_of(radius, drawn))
            break;
    }
    if (good && *count == 0)
        error_set(error, ERROR_USER,
                  "command line: to fill the container to %g takes more than 134 million spheres of this law",
                  options->fraction);
    if (*count > 0)
        return radius;
    memory_free(radius);
    return NULL;
}
