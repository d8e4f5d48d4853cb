/* SPDX-License-Identifier: BSD-3-Clause */
/* A part of space, in which particles are made, inserted, deleted or selected. Lengths are the user's
 * coordinates. */
#ifndef SCREE_SCENE_REGION_H
#define SCREE_SCENE_REGION_H

#include "base/random.h"
#include <stdbool.h>

enum region_shape { REGION_ALL, REGION_BOX, REGION_SPHERE, REGION_CYLINDER, REGION_SURFACE };

struct region;

/* A closed surface that bounds a region: who makes the region also gives these, as no scene names one. */
struct region_surface {
    void *context;
    /* The distance from x to the surface; 0 outside. Any thread. */
    double (*depth)(void *context, const double x[3]);
    /* As region_hold. Any thread. */
    void (*hold)(void *context, const double from[3], double margin, double x[3]);
    double lower[3], upper[3], volume;
};

struct region {
    enum region_shape shape;              /* REGION_ALL: the whole simulation box */
    double lower[3], upper[3];            /* BOX: corners */
    double centre[3];                     /* SPHERE; CYLINDER: middle of the axis */
    double axis[3];                       /* CYLINDER: unit vector */
    double radius;                        /* SPHERE, CYLINDER */
    double length;                        /* CYLINDER: whole length along the axis */
    const struct region_surface *surface; /* SURFACE; borrowed */
};

/* The space of a region: two dimensions or three, and the directions in which the space wraps around (a box
 * that spans a periodic direction has no wall there). */
struct region_space {
    int dimension;
    double plane; /* z of the particles in two dimensions */
    bool wrap[3]; /* for BOX: no margin to the ends of this direction */
};

/* True if a sphere of radius `margin` around x lies wholly inside (margin 0: if the point does; lower faces
 * of a box belong to it, upper faces do not). In two dimensions z is ignored. */
bool region_contains(const struct region *region, const struct region_space *space, const double x[3],
                     double margin);

/* The smallest box around the region. */
void region_bounds(const struct region *region, double lower[3], double upper[3]);

/* Volume; in two dimensions the area of its cut with the plane (a cylinder along z is a disc; other
 * directions are refused by the scene). */
double region_volume(const struct region *region, const struct region_space *space);

/* Radius of the largest sphere (in two dimensions: disc) that lies wholly inside; INFINITY where nothing
 * bounds it. */
double region_inradius(const struct region *region, const struct region_space *space);

/* A uniform point of the region such that a sphere of radius `margin` lies inside: draws from the bounding
 * box until one fits, up to 1000 times; false if none did. */
bool region_draw(const struct region *region, const struct region_space *space, double margin,
                 struct random_sequence *random, double x[3]);

/* Brings a sphere of radius `margin`, which moved to x from a place wholly inside, back inside; changes x. Any thread. */
void region_hold(const struct region *region, const struct region_space *space, const double from[3],
                 double margin, double x[3]);

#endif
