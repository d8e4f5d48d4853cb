/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads a mesh, by the kind of its file. Read mesh.h first. */
#include "physics/grains/walls/mesh.h"
#include "base/numbers.h"
#include "base/memory.h"
#include <string.h>

static bool mesh_table(struct mesh *mesh, char *text, const char *path, struct error *error) {
    struct numbers numbers;
    if (!numbers_parse(&numbers, text, path, 9, error))
        return false;
    mesh->count = numbers.rows;
    mesh->corner = memory_allocate(numbers.rows, sizeof *mesh->corner, "triangles");
    if (numbers.rows > 0)
        memcpy(mesh->corner, numbers.value, numbers.rows * sizeof *mesh->corner);
    mesh->line = numbers.line;
    numbers.line = NULL;
    numbers_free(&numbers);
    return true;
}

/* Other kinds of files that people give for a mesh: what to do with each. */
static const char *mesh_foreign(const char *text, size_t size) {
    if (size > 2 && memcmp(text, "\x1f\x8b", 2) == 0)
        return "is packed by gzip; a mesh must be unpacked: gunzip it";
    if (size > 2 && memcmp(text, "PK", 2) == 0)
        return "is packed by zip; a mesh must be unpacked: unzip it";
    return NULL;
}

/* Parses the content in the given format, or in the format that the content shows. */
static bool mesh_parse(struct mesh *mesh, char *text, size_t size, const char *path, const char *format,
                       struct error *error) {
    bool any = strcmp(format, "") == 0 || strcmp(format, "auto") == 0;
    bool stl = strcmp(format, "stl") == 0;
    bool obj = strcmp(format, "obj") == 0, ply = strcmp(format, "ply") == 0;
    if (!any && !stl && !obj && !ply && strcmp(format, "table") != 0)
        return error_set(error, ERROR_USER, "%s: unknown mesh format '%s'; known: auto, stl, obj, ply, table",
                         path, format);
    const char *foreign = mesh_foreign(text, size);
    if (foreign)
        return error_set(error, ERROR_USER, "%s: %s", path, foreign);
    if (ply || (any && mesh_is_ply(text)))
        return mesh_ply(mesh, text, size, path, error);
    if (obj || (any && mesh_is_obj(text, path)))
        return mesh_obj(mesh, text, path, error);
    if ((any || stl) && mesh_stl_is_binary(text, size))
        return mesh_stl_binary(mesh, text, size, path, error);
    if (stl || (any && mesh_stl_is_ascii(text)))
        return mesh_stl_ascii(mesh, text, path, error);
    if (strlen(text) != size)
        return error_set(error, ERROR_USER, "%s: not a table: byte %zu is zero", path, strlen(text));
    return mesh_table(mesh, text, path, error);
}

bool mesh_read(struct mesh *mesh, const char *path, const char *format, struct error *error) {
    size_t size;
    *mesh = (struct mesh){0};
    char *text = numbers_load(path, &size, error);
    if (text == NULL)
        return false;
    bool good = size > 0 || error_set(error, ERROR_USER, "%s: the file is empty", path);
    good = good && mesh_parse(mesh, text, size, path, format, error);
    good = good && (mesh->count > 0 || error_set(error, ERROR_USER, "%s: no triangle in the file", path));
    memory_free(text);
    if (!good)
        mesh_free(mesh);
    return good;
}

void mesh_free(struct mesh *mesh) {
    memory_free(mesh->corner);
    memory_free(mesh->line);
    *mesh = (struct mesh){0};
}
