/* SPDX-License-Identifier: BSD-3-Clause */
/* The vertices and faces of an OBJ file. Read mesh.h first. */
#include "physics/grains/walls/mesh.h"
#include "base/numbers.h"
#include "base/memory.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The reader between two lines. */
struct obj_text {
    struct mesh *mesh;
    const char *path;
    size_t number; /* of the line, from 1 */
    double (*point)[3];
    long points, room; /* so far; in the array */
};

bool mesh_is_obj(const char *content, const char *path) {
    size_t length = strlen(path);
    while (*content == '#' || *content == '\n' || *content == '\r') /* comments and empty lines */
        content += *content == '#' ? strcspn(content, "\n") : 1;
    return strncmp(content, "v ", 2) == 0 || strncmp(content, "o ", 2) == 0 ||
           strncmp(content, "g ", 2) == 0 || strncmp(content, "mtllib ", 7) == 0 ||
           (length > 4 && strcasecmp(path + length - 4, ".obj") == 0);
}

/* A line `v x y z`; more numbers (a weight, a colour) are left out. */
static bool obj_vertex(struct obj_text *t, char *at, struct error *error) {
    if (t->points == t->room) {
        t->room = t->room ? 2 * t->room : 64;
        t->point = memory_resize(t->point, (size_t)t->room, sizeof *t->point, "vertices of a mesh");
    }
    double *x = t->point[t->points++];
    for (int d = 0; d < 3; d++)
        if (!numbers_word(&at, &x[d]) || !isfinite(x[d]))
            return error_set(error, ERROR_USER, "%s:%zu: an OBJ vertex needs three finite numbers", t->path,
                             t->number);
    return true;
}

/* A line `f a b c ...`; a corner is the number of a vertex, from 1 or, negative, back from the last one, and may go on
 * with a texture and a normal: 3/2/1. */
static bool obj_face(struct obj_text *t, char *at, struct error *error) {
    uint32_t corner[MESH_CORNERS_MAX];
    int corners = 0;
    for (; *(at += strspn(at, " \t")) != '\0'; at += strcspn(at, " \t"), corners++) {
        char *end;
        long number = strtol(at, &end, 10);
        number += number < 0 ? t->points + 1 : 0;
        if (end == at || strchr(" \t/", *end) == NULL || number < 1 || number > t->points)
            return error_set(
                error, ERROR_USER,
                "%s:%zu: '%.*s' is no vertex of this OBJ face; allowed: 1 to %ld, the vertices so far",
                t->path, t->number, (int)strcspn(at, " \t"), at, t->points);
        if (corners < MESH_CORNERS_MAX)
            corner[corners] = (uint32_t)(number - 1);
    }
    if (corners < 3 || corners > MESH_CORNERS_MAX)
        return error_set(error, ERROR_USER, "%s:%zu: an OBJ face of %d corners; allowed: 3 to %d", t->path,
                         t->number, corners, MESH_CORNERS_MAX);
    mesh_add_polygon(t->mesh, t->point, corner, corners, t->number);
    return true;
}

bool mesh_obj(struct mesh *mesh, char *text, const char *path, struct error *error) {
    char *line;
    struct obj_text t = {.mesh = mesh, .path = path};
    bool good = true;
    while (good && (line = numbers_line(&text)) != NULL) {
        t.number++;
        line += strspn(line, " \t");
        bool vertex = line[0] == 'v', face = line[0] == 'f';
        if ((!vertex && !face) || (line[1] != ' ' && line[1] != '\t'))
            continue;
        good = vertex ? obj_vertex(&t, line + 2, error) : obj_face(&t, line + 2, error);
    }
    memory_free(t.point);
    return good && (mesh->count > 0 || error_set(error, ERROR_USER, "%s: no face in the OBJ file", path));
}
