/* SPDX-License-Identifier: BSD-3-Clause */
/* The options of a packing: a law of sizes and its keys. The tables of options.c give parsing, defaults,
 * bounds and help. */
#ifndef SCREE_PACK_OPTIONS_H
#define SCREE_PACK_OPTIONS_H

#include "core/error.h"
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

enum pack_law { PACK_BIDISPERSE, PACK_UNIVOL, PACK_SAND, PACK_EXPONENTIAL, PACK_POWER, PACK_SIEVE };
enum pack_by { PACK_BY_NUMBER, PACK_BY_MASS };
enum pack_sides { PACK_PERIODIC, PACK_HARD };
enum pack_numbers { PACK_TABLE, PACK_RECIPE };

/* Lengths in the unit of the law, see pack_help. Zero counts, box and fraction: not given. */
struct pack_options {
    enum pack_law law;
    enum pack_by by;             /* EXPONENTIAL, SIEVE: what the law counts */
    enum pack_sides walls;       /* all six sides */
    enum pack_numbers numbers;   /* BIDISPERSE */
    double ratio;                /* of the largest to the smallest radius */
    double count;                /* of particles, a whole number */
    double large, small;         /* BIDISPERSE: of either size, whole numbers */
    double box;                  /* edge of the cube */
    double fraction;             /* of the cube's volume that is solid */
    double broad;                /* SAND: part of the particles in the broad peak, by number */
    double scale;                /* EXPONENTIAL: diameter over which the density falls by a factor e */
    double exponent, min, max;   /* POWER: number density of radii ~ r^exponent in [min, max] */
    const char *table;           /* SIEVE: file; borrowed */
    double gap, overlap, sweeps; /* see relax.h; overlap is its bound */
    double velocity;             /* standard deviation of each component */
    double density;
    double seed, threads; /* whole numbers; threads 0: all of OpenMP */
};

/* Fills the options from the law's name and texts KEY=VALUE (borrowed): first the law's defaults, then the
 * texts, then derived values (numbers and box of the published systems). Fails (user) and names the allowed
 * values. */
bool pack_options_read(struct pack_options *options, const char *law, const char *const *setting,
                       int settings, struct error *error);

/* The name of a law. */
const char *pack_law_name(enum pack_law law);

/* Lists the laws, or describes one law in full; false if no law has that name. */
bool pack_help(FILE *out, const char *law);

#endif
