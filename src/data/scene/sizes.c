/* SPDX-License-Identifier: BSD-3-Clause */
/* Laws are given by number or by mass; radii are always drawn by number. A sieve curve by mass is taken as
 * linear in the radius between two sieves, so that the number density there is as r^-3. */
#include "data/scene/sizes.h"

#include <math.h>

/* The balls that a source places over the radii of its law. */
static double ball_of(const struct sizes_options *o) {
    return o->ball > 0 ? o->ball : 1;
}

/* Part of the particles (by number) for a share of the mass, up to a factor: integral of r^-3 over the
 * interval, by its length. */
static double number_weight(double low, double high) {
    return (1 / (low * low) - 1 / (high * high)) / 2 / (high - low);
}

static bool prepare_table(struct sizes_sampler *sampler, struct error *error) {
    const struct sizes_options *o = &sampler->options;
    if (o->points < 2)
        return error_set(error, ERROR_USER, "a table needs two radii at least");
    for (int k = 1; k < o->points; k++)
        if (!(o->radii[k] > o->radii[k - 1]) || o->share[k] < o->share[k - 1])
            return error_set(error, ERROR_USER,
                             "the sizes must increase, and passing must not fall (entry %d, counted from 0)",
                             k);
    if (o->share[0] != 0 || o->share[o->points - 1] != 1)
        return error_set(error, ERROR_USER, "passing must begin with 0 and end with 1");
    sampler->bins = o->points - 1;
    for (int k = 0; k < sampler->bins; k++) {
        double weight = o->by == SIZES_BY_MASS ? number_weight(o->radii[k], o->radii[k + 1]) : 1;
        sampler->cumulative[k] = (o->share[k + 1] - o->share[k]) * weight;
    }
    return true;
}

static bool prepare_discrete(struct sizes_sampler *sampler, struct error *error) {
    const struct sizes_options *o = &sampler->options;
    sampler->bins = o->points;
    double sum = 0;
    for (int k = 0; k < o->points; k++) {
        double r = o->radii[k];
        sampler->cumulative[k] = o->share[k] / (o->by == SIZES_BY_MASS ? r * r * r : 1);
        sum += o->share[k];
    }
    return sum > 0 || error_set(error, ERROR_USER, "all weights are 0");
}

static void accumulate(struct sizes_sampler *sampler) {
    double sum = 0;
    for (int k = 0; k < sampler->bins; k++)
        sum = sampler->cumulative[k] += sum;
    for (int k = 0; k < sampler->bins; k++)
        sampler->cumulative[k] /= sum;
}

bool sizes_prepare(struct sizes_sampler *sampler, const struct sizes_options *options, struct error *error) {
    *sampler = (struct sizes_sampler){.options = *options};
    bool table = options->law == SIZES_TABLE, discrete = options->law == SIZES_DISCRETE;
    if ((table || discrete) && options->points != options->values)
        return error_set(error, ERROR_USER, "%d radii but %d %s", options->points, options->values,
                         table ? "values of passing" : "weights");
    if (table || discrete) {
        if (table ? !prepare_table(sampler, error) : !prepare_discrete(sampler, error))
            return false;
        accumulate(sampler);
        return true;
    }
    if (options->law != SIZES_FIXED && !(options->max > options->min))
        return error_set(error, ERROR_USER, "max (%g) is not above min (%g)", options->max, options->min);
    if (options->law == SIZES_NORMAL || options->law == SIZES_LOGNORMAL) {
        /* a truncation that leaves less than a thousandth of the law would take for ever to draw from */
        bool logarithmic = options->law == SIZES_LOGNORMAL;
        double deviation = logarithmic ? options->width : options->sigma;
        double low = logarithmic ? log(options->min / options->mean) : options->min - options->mean;
        double high = logarithmic ? log(options->max / options->mean) : options->max - options->mean;
        double part = (erf(high / deviation / M_SQRT2) - erf(low / deviation / M_SQRT2)) / 2;
        if (part < 1e-3)
            return error_set(error, ERROR_USER, "only %.2g of the distribution lies between min and max",
                             part);
    }
    return true;
}

/* By inversion of a density r^exponent between two radii. */
static double draw_power(double low, double high, double exponent, double u) {
    double n = exponent + 1;
    if (fabs(n) < 1e-12)
        return low * pow(high / low, u);
    return low * pow(1 + u * (pow(high / low, n) - 1), 1 / n);
}

static double draw_table(const struct sizes_sampler *sampler, struct random_sequence *random) {
    const struct sizes_options *o = &sampler->options;
    double u = random_uniform(random), before = 0;
    int k = 0;
    while (k < sampler->bins - 1 && u >= sampler->cumulative[k])
        before = sampler->cumulative[k++];
    if (o->law == SIZES_DISCRETE)
        return o->radii[k];
    double width = sampler->cumulative[k] - before;
    double within = width > 0 ? (u - before) / width : 0;
    return draw_power(o->radii[k], o->radii[k + 1], o->by == SIZES_BY_MASS ? -3 : 0, within);
}

static double draw_normal(const struct sizes_options *o, struct random_sequence *random) {
    for (;;) {
        double z = random_normal(random);
        double r = o->law == SIZES_NORMAL ? o->mean + o->sigma * z : o->mean * exp(o->width * z);
        if (r >= o->min && r <= o->max)
            return r;
    }
}

/* A radius of the law. */
static double draw_law(const struct sizes_sampler *sampler, struct random_sequence *random) {
    const struct sizes_options *o = &sampler->options;
    switch (o->law) {
    case SIZES_FIXED:
        return o->radius;
    case SIZES_UNIFORM:
        return o->min + (o->max - o->min) * random_uniform(random);
    case SIZES_POWER:
        return draw_power(o->min, o->max, o->exponent, random_uniform(random));
    case SIZES_NORMAL:
    case SIZES_LOGNORMAL:
        return draw_normal(o, random);
    default:
        return draw_table(sampler, random);
    }
}

double sizes_draw(const struct sizes_sampler *sampler, struct random_sequence *random) {
    return ball_of(&sampler->options) * draw_law(sampler, random);
}

/* Integral of x^p from 1 to `end`. */
static double power_integral(double end, double p) {
    return fabs(p + 1) < 1e-12 ? log(end) : (pow(end, p + 1) - 1) / (p + 1);
}

/* Mean of r^power for a density r^exponent between two radii. */
static double power_moment(double low, double high, double exponent, int power) {
    double end = high / low;
    if (!(end > 1))
        return pow(low, power);
    return pow(low, power) * power_integral(end, exponent + power) / power_integral(end, exponent);
}

/* By the trapezoidal rule in the normal variable, whose density times r^power is negligible beyond the span.
 */
static double normal_moment(const struct sizes_options *o, int power) {
    enum { PARTS = 4000 };
    bool logarithmic = o->law == SIZES_LOGNORMAL;
    double low = logarithmic ? log(o->min / o->mean) / o->width : (o->min - o->mean) / o->sigma;
    double high = logarithmic ? log(o->max / o->mean) / o->width : (o->max - o->mean) / o->sigma;
    double sum = 0, weights = 0;
    low = fmax(low, -12);
    high = fmin(high, 12 + (logarithmic ? power * o->width : 0));
    for (int k = 0; k <= PARTS; k++) {
        double z = low + (high - low) * k / PARTS;
        double r = logarithmic ? o->mean * exp(o->width * z) : o->mean + o->sigma * z;
        double weight = exp(-z * z / 2) * (k == 0 || k == PARTS ? 0.5 : 1);
        sum += weight * pow(r, power);
        weights += weight;
    }
    return sum / weights;
}

/* The mean of radius^power of the law. */
static double law_moment(const struct sizes_sampler *sampler, int power) {
    const struct sizes_options *o = &sampler->options;
    double sum = 0, before = 0;
    switch (o->law) {
    case SIZES_FIXED:
        return pow(o->radius, power);
    case SIZES_UNIFORM:
        return power_moment(o->min, o->max, 0, power);
    case SIZES_POWER:
        return power_moment(o->min, o->max, o->exponent, power);
    case SIZES_NORMAL:
    case SIZES_LOGNORMAL:
        return normal_moment(o, power);
    default:
        break;
    }
    for (int k = 0; k < sampler->bins; k++) {
        double share = sampler->cumulative[k] - before;
        double mean = o->law == SIZES_DISCRETE ? pow(o->radii[k], power)
                                               : power_moment(o->radii[k], o->radii[k + 1],
                                                              o->by == SIZES_BY_MASS ? -3 : 0, power);
        sum += share * mean;
        before = sampler->cumulative[k];
    }
    return sum;
}

double sizes_moment(const struct sizes_sampler *sampler, int power) {
    return pow(ball_of(&sampler->options), power) * law_moment(sampler, power);
}

void sizes_bounds(const struct sizes_options *o, double *smallest, double *largest) {
    bool listed = o->law == SIZES_TABLE || o->law == SIZES_DISCRETE;
    *smallest = o->law == SIZES_FIXED ? o->radius : o->min;
    *largest = o->law == SIZES_FIXED ? o->radius : o->max;
    for (int k = 0; listed && k < o->points; k++) {
        *smallest = k && *smallest < o->radii[k] ? *smallest : o->radii[k];
        *largest = k && *largest > o->radii[k] ? *largest : o->radii[k];
    }
    *smallest *= ball_of(o);
    *largest *= ball_of(o);
}
