/* SPDX-License-Identifier: BSD-3-Clause */
/* The walls of a scene at a time, as things that can be drawn; user's coordinates. */
#ifndef SCREE_PICTURE_SHAPES_H
#define SCREE_PICTURE_SHAPES_H

#include "data/formats/checkpoint_state.h"
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
    bool unknown; /* particles move a wall (a servo, or a free one), whose place at `time` is not known */
};

/* When, and the poses of walls then as a checkpoint tells them; 0 walls: they follow from the scene. */
struct shapes_moment {
    double time;
    int walls;
    const struct checkpoint_wall *wall;
};

/* Places the walls; shapes_free releases. Walls that particles move stay where they begin unless their pose is told. Fails as
 * walls_create. One thread. */
bool shapes_make(struct shapes *shapes, const struct scene *scene, const struct shapes_moment *moment,
                 struct error *error);
void shapes_free(struct shapes *shapes);

/* Cuts planes and endless tubes to a box: fills corners (0: the plane misses the box) and ends. */
void shapes_cut(struct shapes *shapes, const double lower[3], const double upper[3]);

#endif
