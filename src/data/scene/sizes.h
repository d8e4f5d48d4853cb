/* SPDX-License-Identifier: BSD-3-Clause */
/* Size laws: the sizes of the particles of a source. A law is options (plain data); a sampler is prepared
 * once from the options. Radii depend on the random sequence alone. Where a source names a shape of bodies, the radii that a sampler
 * gives are those of the balls around the bodies. */
#ifndef SCREE_SCENE_SIZES_H
#define SCREE_SCENE_SIZES_H

#include "base/error.h"
#include "base/random.h"
#include <stdbool.h>

enum { SIZES_POINTS_MAX = 64, SIZES_PATH_MAX = 1024 };

enum sizes_law {
    SIZES_FIXED,
    SIZES_UNIFORM,
    SIZES_NORMAL,
    SIZES_LOGNORMAL,
    SIZES_POWER,
    SIZES_TABLE,
    SIZES_DISCRETE
};
enum sizes_by { SIZES_BY_NUMBER, SIZES_BY_MASS };

struct sizes_options {
    enum sizes_law law;
    double radius;                  /* FIXED, length unit */
    double min, max;                /* UNIFORM, POWER: bounds; NORMAL, LOGNORMAL: truncation; length unit */
    double mean;                    /* NORMAL: mean; LOGNORMAL: median; length unit */
    double sigma;                   /* NORMAL: standard deviation, length unit */
    double width;                   /* LOGNORMAL: standard deviation of ln r */
    double exponent;                /* POWER: number density f(r) ~ r^exponent */
    enum sizes_by by;               /* TABLE, DISCRETE: what passing and weights count */
    int points, values;             /* how many of the following */
    double radii[SIZES_POINTS_MAX]; /* TABLE: sieve radii, increasing; DISCRETE: the sizes; length unit */
    double share[SIZES_POINTS_MAX]; /* TABLE: part that passes, from 0 rising to 1; DISCRETE: weights */
    /* other forms of TABLE and DISCRETE, as a user gives them; sizes_file_complete turns them into the above */
    int diameters;
    double diameter[SIZES_POINTS_MAX]; /* instead of radii, length unit */
    char file[SIZES_PATH_MAX];         /* instead of radii and share; "": none */
    double file_unit;                  /* length of one in the file, length unit */
    double
        ball; /* no key: radius of the ball around a body over the radius of the law; 0: 1, as no shape is named */
};

struct sizes_sampler {
    struct sizes_options options;
    int bins;
    double cumulative[SIZES_POINTS_MAX]; /* TABLE, DISCRETE: by number, normalised */
};

/* Prepares a sampler. Fails (user) on tables that do not rise, empty ranges, unequal lengths; the text names
 * the mistake but no place. */
bool sizes_prepare(struct sizes_sampler *sampler, const struct sizes_options *options, struct error *error);

/* One radius, by number. Draws a varying count of numbers from the sequence. */
double sizes_draw(const struct sizes_sampler *sampler, struct random_sequence *random);

/* The mean of radius^power over the radii that sizes_draw gives: closed forms, for the normal laws a
 * quadrature good to about 1e-6. */
double sizes_moment(const struct sizes_sampler *sampler, int power);

/* Smallest and largest radius that the law can give. */
void sizes_bounds(const struct sizes_options *options, double *smallest, double *largest);

#endif
