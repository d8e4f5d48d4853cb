/* SPDX-License-Identifier: BSD-3-Clause */
/* Triangle meshes as files hold them: STL (ASCII or binary), OBJ, PLY, or a table of nine numbers a row. Only read here;
 * wall_mesh.h makes the surface of a wall from the triangles. */
#ifndef SCREE_WALLS_MESH_H
#define SCREE_WALLS_MESH_H

#include "base/error.h"
#include <stddef.h>
#include <stdint.h>

/* Triangles in the order of the file. */
struct mesh {
    size_t count, room;  /* triangles; those that the arrays have room for (mesh_add) */
    double (*corner)[9]; /* x y z of the three corners, in the units of the file; finite */
    uint32_t *line; /* line of each triangle in the file, from 1 (ASCII STL: of its `facet`); NULL: binary */
};

/* Reads a mesh. `format` is "stl", "obj", "ply", "table", or "" or "auto" to decide by the content. Normals in an STL file
 * are ignored. Fails (user, with file and line or triangle number) on an unknown format, a file that cannot
 * be read, is truncated or longer than it says, breaks the grammar, has numbers that are not finite, or no
 * triangle. mesh_free releases. One thread. */
bool mesh_read(struct mesh *mesh, const char *path, const char *format, struct error *error);
void mesh_free(struct mesh *mesh);

/* True if the content is a binary or an ASCII STL file. */
bool mesh_stl_is_binary(const char *content, size_t size);
bool mesh_stl_is_ascii(const char *content);

/* Read the content of an STL file (ASCII: changed); `path` is for messages. Used by mesh_read. */
bool mesh_stl_binary(struct mesh *mesh, const char *content, size_t size, const char *path,
                     struct error *error);
bool mesh_stl_ascii(struct mesh *mesh, char *text, const char *path, struct error *error);

/* Read the content of an OBJ or a PLY file, which is changed; polygons become triangles. `path` is for messages. Used by
 * mesh_read.
 *
 * OBJ: lines `v` and `f` count, all others are left out. PLY: ASCII, or binary of either byte order; of the elements only
 * `vertex` (x, y, z) and, after it, `face` (vertex_indices or vertex_index) count. Fail (user, with the line, or in a binary
 * file the number of the vertex or face) if a vertex has no three finite numbers, a face has fewer corners than 3 or more
 * than MESH_CORNERS_MAX or a corner that is no vertex, or the file is not as long as its header says. */
enum { MESH_CORNERS_MAX = 1024 };
bool mesh_obj(struct mesh *mesh, char *text, const char *path, struct error *error);
bool mesh_ply(struct mesh *mesh, char *content, size_t size, const char *path, struct error *error);

/* True if the content is a PLY file; true if the content, or the end of the path, is that of an OBJ file. */
bool mesh_is_ply(const char *content);
bool mesh_is_obj(const char *content, const char *path);

/* Adds a triangle of this line (0: the file has no lines; in all calls for a mesh, or in none). Returns its nine numbers, to
 * be set. Valid up to the next call. */
double *mesh_add(struct mesh *mesh, size_t line);

/* Adds the triangles of a polygon of 3 to MESH_CORNERS_MAX corners; corner k is at point[corner[k]]. A polygon of n corners
 * becomes n - 2 triangles that turn like it. */
void mesh_add_polygon(struct mesh *mesh, const double (*point)[3], const uint32_t *corner, int corners,
                      size_t line);

#endif
