/* SPDX-License-Identifier: BSD-3-Clause */
/* Triangle meshes as files hold them: STL (ASCII or binary), OBJ, PLY, or a table of nine numbers a row. Only read here;
 * wall_mesh.h makes the surface of a wall from the triangles. */
#ifndef SCREE_WALLS_MESH_H
#define SCREE_WALLS_MESH_H

#include "core/error.h"
#include <stddef.h>
#include <stdint.h>

/* Triangles in the order of the file. */
struct mesh {
    size_t count;
    double (*corner)[9]; /* x y z of the three corners, in the units of the file; finite */
    uint32_t *line; /* line of each triangle in the file, from 1 (ASCII STL: of its `facet`); NULL: binary */
};

/* Reads a mesh. `format` is "stl", "obj", "ply" (mesh_import), "table", or "" or "auto" to decide by the content. Normals in an STL file
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

/* OBJ and PLY files, read by assimp, a library that is loaded when a scene first has such a file.
 *
 * "obj" or "ply" if the content, or the end of the path, is that of such a file; else NULL. */
const char *mesh_import_format(const char *content, const char *path);

/* The vertices and faces of an OBJ file (the text is changed) as a text of `v` and `f` lines without all else; *size is
 * its length. NULL with an error (user, with the line) if a vertex has no three finite numbers, or a face no three
 * corners or a corner that is no vertex of a line before, or if there is no face. The caller calls free. One thread. */
char *mesh_obj_plain(char *text, const char *path, size_t *size, struct error *error);

/* Reads the content of a file of this format (the text is changed); polygons become triangles, and the parts of a file become one mesh.
 * assimp reads numbers as floats (seven digits). Fails (user) if the program was built without assimp, if assimp is
 * not there, or if assimp refuses the file, with assimp's own words. mesh_free releases. One thread. */
bool mesh_import(struct mesh *mesh, char *content, size_t size, const char *format, const char *path,
                 struct error *error);

#endif
