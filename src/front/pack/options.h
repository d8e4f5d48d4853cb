/* SPDX-License-Identifier: BSD-3-Clause */
/* The options of a packing: a law of sizes and its keys. options_read.h reads them, laws.h has their
 * table. */
#ifndef SCREE_PACK_OPTIONS_H
#define SCREE_PACK_OPTIONS_H

#include <stdint.h>

enum pack_law {
    PACK_BIDISPERSE,
    PACK_UNIVOL,
    PACK_SAND,
    PACK_EXPONENTIAL,
    PACK_POWER,
    PACK_SIEVE,
    PACK_DISCRETE
};
enum pack_by { PACK_BY_NUMBER, PACK_BY_MASS };
enum pack_sides { PACK_PERIODIC, PACK_HARD };
enum pack_shape { PACK_CUBE, PACK_BOX, PACK_CYLINDER, PACK_SPHERE, PACK_MESH };
enum pack_rest { PACK_FLOATING, PACK_SETTLED };
enum pack_numbers { PACK_TABLE, PACK_RECIPE };

/* Lengths in the unit of the law, see pack_help. Zero counts, box and fraction: not given. */
struct pack_options {
    enum pack_law law;
    enum pack_by by;           /* EXPONENTIAL, SIEVE, DISCRETE: what the law counts */
    enum pack_sides walls;     /* all six sides; HARD in round containers and meshes */
    enum pack_numbers numbers; /* BIDISPERSE */
    double ratio;              /* of the largest to the smallest radius */
    double count;              /* of particles, a whole number */
    double large, small;       /* BIDISPERSE: of either size, whole numbers */
    double box;                /* edge of the cube */
    double
        fraction; /* of the container's volume that is solid; where the size is known and the count is not, as many
                      * particles as reach it */
    enum pack_shape shape;     /* of the container */
    double edges[3];           /* BOX */
    double radius, length;     /* CYLINDER, SPHERE */
    const char *file;          /* MESH; borrowed */
    double scaled;             /* MESH: coordinates of the file x this */
    double broad;              /* SAND: part of the particles in the broad peak, by number */
    double scale;              /* EXPONENTIAL: diameter over which the density falls by a factor e */
    double exponent, min, max; /* POWER: number density of radii ~ r^exponent in [min, max] */
    const char *table;         /* SIEVE, DISCRETE: file; borrowed */
    /* SIEVE, DISCRETE, instead of the file: lists, "1,2,4"; borrowed */
    const char *radii, *diameters, *passing, *weights;
    double gap, overlap, sweeps; /* see relax.h; overlap is its bound */
    enum pack_rest settle;       /* SETTLED: the spheres then fall along -z and come to rest on each other */
    double friction;             /* SETTLED: of the spheres while they fall */
    double velocity;             /* standard deviation of each component */
    double density;
    double seed, threads; /* whole numbers; threads 0: all of OpenMP */
};

#endif
