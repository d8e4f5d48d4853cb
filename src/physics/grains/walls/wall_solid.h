/* SPDX-License-Identifier: BSD-3-Clause */
/* What a solid with corners and edges meets of a wall: the contacts of a sphere at a corner of the solid, and the edges and
 * vertices of the wall. The solid lies in the ball of an owned particle, for which walls_build has found the pieces of walls
 * nearby. */
#ifndef SCREE_WALLS_WALL_SOLID_H
#define SCREE_WALLS_WALL_SOLID_H

#include "physics/grains/walls/wall.h"

/* The pieces of one image of a wall near a particle. Valid up to the next walls_build. */
struct wall_group {
    int wall, image;
    size_t first, count;
};

/* Finds the next group of a particle; the first one where `count` is 0. False: there is none. Any thread. */
bool walls_group_next(const struct walls *walls, size_t particle, struct wall_group *group);

/* The vector from the wall to its image. */
void walls_group_shift(const struct walls *walls, const struct wall_group *group, double shift[3]);

/* A contact of a sphere at a corner. */
struct wall_corner {
    int32_t feature;  /* of the wall */
    double distance;  /* from the centre to the wall; below 0 beyond a wall of one side */
    double normal[3]; /* unit vector from the centre to the wall, or where it is beyond, to its outside */
};

/* A straight edge of a wall, about a place. An edge where the wall is concave towards it is none. */
struct wall_edge {
    double end[2][3];
    double inward[3]; /* sum of the unit vectors into the faces at the edge; 0 of the rim of a surface */
    double radius;    /* of a cylinder, whose axis this is; else 0 */
    int32_t feature;
    int faces;
};

/* A vertex. */
struct wall_vertex {
    double place[3], inward[3];
    int32_t feature;
};

/* Memory of a thread, zeros at the start. walls_probe_free releases. */
struct wall_scratch;
struct walls_probe {
    struct wall_scratch *scratch;
    size_t corners, edges, vertices, corner_room, edge_room, vertex_room;
    struct wall_corner *corner;
    struct wall_edge *edge;
    struct wall_vertex *vertex;
};
void walls_probe_free(struct walls_probe *probe);

/* Fills probe->corner: the contacts of a sphere, whose centre lies in the ball of the particle, with a group. Any thread, with a
 * probe of its own. */
void walls_group_touch(const struct walls *walls, const struct wall_group *group, const double x[3],
                       double radius, struct walls_probe *probe);

/* Fills probe->edge and probe->vertex with those of the group that are nearer than `reach` to x; places are about x. Round rims
 * are edges of WALL_SOLID_SIDES sides. */
enum { WALL_SOLID_SIDES = 96 };
void walls_group_edges(const struct walls *walls, const struct wall_group *group, const double x[3],
                       double reach, struct walls_probe *probe);

/* True if the far side of the wall is solid: a plane, an endless cylinder. */
bool walls_one_sided(const struct walls *walls, int wall);

#endif
