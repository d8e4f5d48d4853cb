/* SPDX-License-Identifier: BSD-3-Clause */
/* The surface that a wall makes of the triangles of a file: vertices merged, flat patches found, and the
 * edges and vertices named at which a sphere can touch something else than a patch.
 *
 * With L the diagonal of the mesh's bounding box:
 *   - corners nearer than 1e-6 L to an earlier vertex become that vertex
 *   - triangles of a height of 1e-6 L or less, and triangles with the corners of an earlier one, are left
 *     out, each with a note
 *   - a flat patch is a set of triangles connected by edges whose corners lie within 1e-6 L of one plane
 *     (that of its largest triangle) and whose normals are within 1e-3 rad of it (or whose corners lie within
 *     1e-7 L of the plane, as the normals of tiny triangles are noise). All of its triangles are the plane
 *     that is the mean of theirs, weighted by area
 *   - an edge of a triangle is a feature unless the patch goes on behind it; a vertex is a feature of the
 *     patches that have such an edge there
 *
 * Features are numbered: patches, then edges, then vertices; the numbers depend on the file alone. Coordinates
 * are those of the body: box-relative, before any motion. */
#ifndef SCREE_WALLS_WALL_MESH_H
#define SCREE_WALLS_WALL_MESH_H

#include "physics/grains/laws/law_kernel.h"
#include "physics/grains/walls/mesh.h"
#include <stdio.h>

struct wall_triangle {
    int32_t patch;
    int32_t edge[3];             /* feature of edge k, which runs from corner k to k + 1; -1: none */
    int32_t vertex[3];           /* feature of corner k; -1: none */
    struct law_vector inward[3]; /* unit vector in the patch's plane across edge k, towards the inside */
    struct law_vector corner[3];
};

struct wall_patch {
    struct law_vector normal; /* unit vector */
    struct law_vector point;  /* its centroid: heights from here lose the fewest digits */
};

struct wall_mesh {
    size_t triangles, patches, edges, vertices;
    struct wall_triangle *triangle;
    struct wall_patch *patch;
    struct law_vector (*edge)[2]; /* ends of the feature patches + e */
    struct law_vector *vertex;    /* position of the feature patches + edges + v */
    struct law_vector lower, upper;
    struct law_vector centre; /* of the bounding box */
    double radius;            /* of the ball around the centre that holds the mesh */
    double tolerance;         /* 1e-6 L */
    double slack; /* a foot outside of a triangle, in its plane, by less counts as inside: rounding */
};

/* Transformation of the coordinates of the file: x scale + shift. */
struct wall_mesh_place {
    double scale;
    double shift[3];
};

/* Makes the surface of a mesh read from `path` (for messages). `notes` (may be NULL) receives a line for each
 * repair, up to 20 of a kind. Fails (user) if nothing is left, or lengths are too large or too small to be
 * handled. One thread. Destroy frees and nulls. */
bool wall_mesh_create(struct wall_mesh **mesh, const struct mesh *file, const char *path,
                      const struct wall_mesh_place *place, FILE *notes, struct error *error);
void wall_mesh_destroy(struct wall_mesh **mesh);

static inline size_t wall_mesh_features(const struct wall_mesh *mesh) {
    return mesh->patches + mesh->edges + mesh->vertices;
}

/* The least angle (rad) of more than `above` by which the surface turns at an edge between two patches; INFINITY
 * without such an edge. Of an edge of more than two triangles only the first and each other one count. */
double wall_mesh_turn(const struct wall_mesh *mesh, double above);

/* The number of edges that are not shared by two triangles, with `oriented` by two of one orientation: 0 of a closed
 * surface. */
size_t wall_mesh_open_edges(const struct wall_mesh *mesh, bool oriented);

/* The area of all triangles. */
double wall_mesh_area(const struct wall_mesh *mesh);

/* Between the two files that make a surface: merged vertices and the triangles that are left. */
struct wall_weld {
    size_t vertices, triangles;
    struct law_vector *vertex;
    int32_t (*corner)[3]; /* vertices of each triangle */
    double tolerance;
};

/* Finds patches and features of the welded triangles and fills the mesh. (wall_patch.c) */
void wall_patch_find(struct wall_mesh *mesh, const struct wall_weld *weld);

#endif
