/* SPDX-License-Identifier: BSD-3-Clause */
/* The surface of a closed mesh as a field: signed distances at the nodes of a grid, negative in the solid, from which the
 * normals of the triangles point away. The distance at a place is interpolated, by cubics through the four nearest nodes in
 * each direction (Catmull and Rom, 1974); the normal is the exact gradient of this interpolant, which has no jumps, so that
 * facets are smoothed over a spacing or two. A look-up takes the same 64 nodes, however many triangles there are.
 *
 * Nodes are there only near the surface, in tiles of WALL_FIELD_CELLS cells a side with a rim of nodes around them. The values
 * do not depend on how far the tiles reach. The interpolant is exact near one plane; its error is of third order in the
 * spacing where the distance is smooth, of second order around convex edges, and about a tenth of the spacing within one
 * spacing of places that are as far from two parts of the surface: there the nearer part takes over.
 *
 * Coordinates are those of the body. Any thread may look; one thread covers. */
#ifndef SCREE_WALLS_WALL_FIELD_H
#define SCREE_WALLS_WALL_FIELD_H

#include "physics/grains/walls/wall_mesh.h"

enum { WALL_FIELD_CELLS = 8, WALL_FIELD_ACROSS = 2048, WALL_FIELD_USUAL = 128 };

struct wall_field;

/* Prepares the field of a mesh, which is borrowed, as the name is; tiles come with wall_field_cover. `spacing` not above 0, or NAN: a
 * WALL_FIELD_USUALth of the longest side of the box around the mesh. Fails (user) if the mesh is not closed, or the spacing
 * is below a WALL_FIELD_ACROSSth of that side. Destroy frees and nulls. */
bool wall_field_create(struct wall_field **field, const struct wall_mesh *mesh, double spacing,
                       const char *name, struct error *error);
void wall_field_destroy(struct wall_field **field);

/* Makes the tiles of all places nearer to the surface than `reach`, and some more, if they are not there. Ends the program with
 * a message where memory does not suffice. Opens its own team. */
void wall_field_cover(struct wall_field *field, double reach);

/* Distance and gradient (of a length near 1) at a place; false: no tile is there, and it is farther than the reach. */
bool wall_field_at(const struct wall_field *field, struct law_vector x, double *distance,
                   struct law_vector *gradient);

/* The same at any place nearer to the surface than `reach`: where no tile is there those of the triangles, exactly. False: it is
 * farther. */
bool wall_field_near(const struct wall_field *field, struct law_vector x, double reach, double *distance,
                     struct law_vector *gradient);

/* What `scree check` tells: the error is the largest distance to the exact one that was found in the middle of
 * WALL_FIELD_LOOKS cells of each tile. */
enum { WALL_FIELD_LOOKS = 64 };
struct wall_field_figures {
    double spacing, error; /* length */
    size_t tiles, bytes;
};
struct wall_field_figures wall_field_look(const struct wall_field *field);

#endif
