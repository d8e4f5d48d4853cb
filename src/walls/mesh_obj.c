/* SPDX-License-Identifier: BSD-3-Clause */
/* The corners and faces of an OBJ file, without all else. Read mesh.h first.
 *
 * assimp looks at materials, textures and groups, too, and may crash where a face names a vertex that is not there. So
 * assimp gets a text of lines `v x y z` and `f a b c ...` alone, whose numbers have been looked at. */
#include "walls/mesh.h"
#include "files/numbers.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The reader between two lines. */
struct obj_text {
    const char *path;
    size_t number;        /* of the line, from 1 */
    long vertices, faces; /* so far */
    FILE *out;
};

/* A line `v x y z`; more numbers (a weight, a colour) are left out. */
static bool obj_vertex(struct obj_text *t, char *at, struct error *error) {
    double x[3];
    for (int d = 0; d < 3; d++)
        if (!numbers_word(&at, &x[d]) || !isfinite(x[d]))
            return error_set(error, ERROR_USER, "%s:%zu: an OBJ vertex needs three finite numbers", t->path,
                             t->number);
    fprintf(t->out, "v %.17g %.17g %.17g\n", x[0], x[1], x[2]);
    t->vertices++;
    return true;
}

/* A line `f a b c ...`; a corner is the number of a vertex, from 1 or, negative, back from the last one, and may go on
 * with a texture and a normal: 3/2/1. */
static bool obj_face(struct obj_text *t, char *at, struct error *error) {
    int corners = 0;
    fprintf(t->out, "f");
    while (*(at += strspn(at, " \t")) != '\0') {
        char *end;
        long corner = strtol(at, &end, 10);
        corner += corner < 0 ? t->vertices + 1 : 0;
        if (end == at || strchr(" \t/", *end) == NULL || corner < 1 || corner > t->vertices)
            return error_set(
                error, ERROR_USER,
                "%s:%zu: '%.*s' is no vertex of this OBJ face; allowed: 1 to %ld, the vertices so far",
                t->path, t->number, (int)strcspn(at, " \t"), at, t->vertices);
        fprintf(t->out, " %ld", corner);
        at += strcspn(at, " \t");
        corners++;
    }
    fprintf(t->out, "\n");
    t->faces++;
    return corners >= 3 ||
           error_set(error, ERROR_USER, "%s:%zu: an OBJ face of %d corners, not of three or more", t->path,
                     t->number, corners);
}

char *mesh_obj_plain(char *text, const char *path, size_t *size, struct error *error) {
    char *plain = NULL, *line;
    struct obj_text t = {.path = path, .out = open_memstream(&plain, size)};
    bool good = t.out != NULL || error_set(error, ERROR_SYSTEM, "%s: no memory for its text", path);
    while (good && (line = numbers_line(&text)) != NULL) {
        t.number++;
        line += strspn(line, " \t");
        bool vertex = line[0] == 'v', face = line[0] == 'f';
        if ((!vertex && !face) || (line[1] != ' ' && line[1] != '\t'))
            continue;
        good = vertex ? obj_vertex(&t, line + 2, error) : obj_face(&t, line + 2, error);
    }
    good = good && (t.faces > 0 || error_set(error, ERROR_USER, "%s: no face in the OBJ file", path));
    if (t.out != NULL)
        fclose(t.out);
    if (good)
        return plain;
    free(plain);
    return NULL;
}
