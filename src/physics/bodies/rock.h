/* SPDX-License-Identifier: BSD-3-Clause */
/* Rocks: convex bodies with flat faces, and edges and corners that are rounded by spheres of one radius.
 *
 * The faces of the entry's solid stay where they are: the core of the rock is the solid without a layer as thick as the radius, and the rock
 * is all that is nearer than the radius to the core. Mass, centre and inertia are those of the sharp solid, exactly
 * (moments_solid); what the rounding takes from edges and corners is not taken off. */
#ifndef SCREE_BODIES_ROCK_H
#define SCREE_BODIES_ROCK_H

#include "physics/bodies/clump.h"

enum { ROCKS_MAX = 16, ROCK_VARIANTS_MAX = 64 };

/* The law of random rocks: the hull of corners on an ellipsoid. */
struct rock_draw {
    int corners;                 /* drawn; some may lie inside of the hull */
    int variants;                /* shapes, of which each grain takes one by its id */
    double elongation, flatness; /* middle axis over longest, shortest over middle */
    double roundness;            /* rounding over the distance from the centre to the nearest face */
};

/* An entry of `bodies.shapes`. */
struct rock_options {
    struct clump_entry entry;
    int numbers;
    double vertex[3 * SOLID_CORNERS_MAX]; /* x y z of each corner */
    char file[CLUMP_PATH_MAX];            /* "": none; else a mesh */
    double scale;                         /* lengths of the file x this */
    bool hull;                            /* the hull of the file stands for it */
    int random;                           /* 1: drawn */
    struct rock_draw draw;
    double rounding; /* length; NAN: by the roundness */
};

/* Makes shape `variant` of entry `number` of bodies.shapes. False, with a user's error, where it cannot be one. clump_free
 * releases it. */
bool rock_make(struct clump *clump, const struct scene *scene, int number, const struct rock_options *options,
               int variant, struct error *error);

#endif
