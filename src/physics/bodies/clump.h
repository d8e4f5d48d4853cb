/* SPDX-License-Identifier: BSD-3-Clause */
/* The shapes of rigid bodies, with mass, centre of mass and moments of inertia: clumps, which are lists of spheres, and rocks
 * (rock.h), which have a convex core instead. */
#ifndef SCREE_BODIES_CLUMP_H
#define SCREE_BODIES_CLUMP_H

#include "base/moments.h"
#include "physics/bodies/shapes/solid.h"
#include "data/scene/scene.h"

enum { CLUMPS_MAX = 32, CLUMP_SPHERES_MAX = 32, CLUMP_PATH_MAX = 256 };

enum clump_orientation { CLUMP_RANDOM, CLUMP_GIVEN };
/* CLUMP_AUTO stands only until the scene has been read (bodies_finish). */
enum clump_size { CLUMP_BY_GRAIN, CLUMP_AS_DRAWN, CLUMP_BY_VOLUME, CLUMP_AUTO };

/* What entries of all shapes say: which grains become such bodies, and how they begin. */
struct clump_entry {
    char name[SCENE_NAME_MAX];
    int material;                     /* grains of this material become such bodies; -1: the only one */
    double radius_above, radius_upto; /* of grains that become such bodies */
    bool named;                       /* no key: sources name this entry, and it takes their grains alone */
    enum clump_size size;
    double mass; /* NAN: from the density of the grains' material */
    enum clump_orientation orientation;
    int quaternion_given;
    double quaternion[4];       /* w x y z */
    double angular_velocity[3]; /* added to that of the grain, rad/time */
};

/* An entry of `bodies.clumps`. */
struct clump_options {
    struct clump_entry entry;
    int spheres;
    struct clump_sphere sphere[CLUMP_SPHERES_MAX];
    char file[CLUMP_PATH_MAX]; /* "": spheres are given; else rows of x y z radius */
    char mesh[CLUMP_PATH_MAX]; /* "": no mesh; else a closed surface, filled with spheres (inscribe.h) */
    int mesh_spheres;          /* at most */
    double scale;              /* lengths of the file or mesh x this */
    int centre_given;
    double centre[3]; /* of mass; NAN: by the spheres */
    int inertia_given;
    double inertia[6]; /* xx yy zz xy xz yz about the centre of mass; none given: by the spheres */
};

/* A shape in the frame of its principal axes, the centre of mass at the origin. Lengths are those of the scene's
 * entry; a body is scaled. */
struct clump {
    int spheres;
    struct clump_sphere *sphere;
    double *share;      /* of each sphere: its part of the mass; all together 1 */
    double volume;      /* of the union of the spheres; of the mesh that they fill */
    double filled;      /* of a mesh: part of the volume that the spheres fill; else 0 */
    double mass;        /* NAN: volume x density */
    double extent;      /* radius of the ball about the centre of mass that holds all spheres */
    double centre[3];   /* of mass, in the frame of the entry */
    double gyration[3]; /* moments of inertia over mass, from small to large */
    double rest
        [9]; /* inertia over mass that the spheres' shares do not account for, row by row; 0 where none overlap */
    double ease;    /* of a clump: the largest inertia that the spheres' shares have over that of the body, at
                       least 1 */
    double axes[4]; /* turns this frame to that of the entry */
    double span;    /* size: volume: radius of the grain that becomes the shape in the size of the entry */
    bool overlap;
    struct solid
        core;        /* of a rock, in this frame: its one sphere is the ball around it. No corners: a clump */
    double rounding; /* of a rock: it is all that is nearer than this to the core */
    double inner; /* of a rock: radius of the sphere about the centre of mass that touches its nearest face */
    double
        corner; /* of a rock: how far a push on a corner moves it, over one on its middle (physics/bodies/shapes/stiff.h) */
    double seat[3]; /* of a rock: a contact along its faces (physics/bodies/shapes/stiff.h) */
};

/* Makes a shape. Reads its file. False, with a user's error, where it cannot be one. clump_free releases it. */
bool clump_make(struct clump *clump, const struct scene *scene, int number,
                const struct clump_options *options, struct error *error);
void clump_free(struct clump *clump);

/* The radius of the largest sphere about the centre of sphere `number` in what it stands for: of a rock in the rock. */
static inline double clump_inner(const struct clump *clump, int number) {
    return clump->core.corners > 0 ? clump->inner : clump->sphere[number].radius;
}

/* Mass of a body of which all lengths are `scale` x those of the shape. */
double clump_mass(const struct clump *clump, double scale, double density);

#endif
