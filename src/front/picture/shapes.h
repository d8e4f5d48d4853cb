/* SPDX-License-Identifier: BSD-3-Clause */
/* The walls of a scene at a time, as things that can be drawn; user's coordinates. */
#ifndef SCREE_PICTURE_SHAPES_H
#define SCREE_PICTURE_SHAPES_H

#include "data/scene/scene.h"

enum { SHAPE_CORNERS_MAX = 6 };

struct shape_plane {
    double point[3], normal[3]; /* normal: towards the particles */
    int corners;
    double corner[SHAPE_CORNERS_MAX][3];
};

struct shape_tube {
    double point[3], axis[3], radius; /* axis: unit length */
    double length;                    /* 0: endless */
    double end[2][3];
};

struct shapes {
    size_t triangles;
    double (*triangle)[9];
    int planes, tubes;
    struct shape_plane plane[WALLS_MAX];
    struct shape_tube tube[WALLS_MAX];
    bool unknown; /* a servo moves a wall: its place at `time` is not known */
};

/* Places the walls at a time; shapes_free releases. Walls that a servo drives stay where they begin. Fails as
 * walls_create. One thread. */
bool shapes_make(struct shapes *shapes, const struct scene *scene, double time, struct error *error);
void shapes_free(struct shapes *shapes);

/* Cuts planes and endless tubes to a box: fills corners (0: the plane misses the box) and ends. */
void shapes_cut(struct shapes *shapes, const double lower[3], const double upper[3]);

#endif
