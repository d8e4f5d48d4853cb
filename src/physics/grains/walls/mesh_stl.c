/* SPDX-License-Identifier: BSD-3-Clause */
/* STL files.
 *
 * Binary: 80 bytes of header, the number of triangles (32 bits, little-endian), then 50 bytes a triangle:
 * normal and three corners as 12 floats, and 2 bytes without meaning. A header may begin with "solid" too, so
 * the length decides: 84 + 50 n bytes are binary; else a file with a zero byte, as text has none.
 *
 * ASCII: `solid NAME`, then for each triangle the lines facet normal, outer loop, three times vertex,
 * endloop, endfacet; `endsolid NAME`. Several solids may follow one another. Capitals are as good as small
 * letters. */
#include "physics/grains/walls/mesh.h"
#include "base/numbers.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>
#include <strings.h>

enum { STL_HEADER = 84, STL_RECORD = 50, STL_NORMAL = 12 };

static uint32_t stl_word(const char *bytes) {
    const unsigned char *b = (const unsigned char *)bytes;
    return (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

static double stl_float(const char *bytes) {
    uint32_t word = stl_word(bytes);
    float value;
    memcpy(&value, &word, sizeof value);
    return value;
}

bool mesh_stl_is_binary(const char *content, size_t size) {
    if (size >= STL_HEADER && size == STL_HEADER + (size_t)STL_RECORD * stl_word(content + STL_HEADER - 4))
        return true;
    return memchr(content, '\0', size) != NULL;
}

bool mesh_stl_is_ascii(const char *content) {
    content += strspn(content, " \t\r\n");
    return strncasecmp(content, "solid", 5) == 0 && strchr(" \t\r\n", content[5]) != NULL;
}

bool mesh_stl_binary(struct mesh *mesh, const char *content, size_t size, const char *path,
                     struct error *error) {
    if (size < STL_HEADER)
        return error_set(error, ERROR_USER, "%s: truncated: %zu bytes, a binary STL file has at least %d",
                         path, size, STL_HEADER);
    size_t count = stl_word(content + STL_HEADER - 4), needs = STL_HEADER + STL_RECORD * count;
    if (size != needs)
        return error_set(error, ERROR_USER,
                         "%s: %s: %zu triangles, as it says, take %zu bytes, the file has %zu", path,
                         size < needs ? "truncated" : "too long", count, needs, size);
    mesh->corner = memory_allocate(count, sizeof *mesh->corner, "triangles");
    mesh->count = count;
    for (size_t k = 0; k < count; k++)
        for (size_t c = 0; c < 9; c++) {
            mesh->corner[k][c] = stl_float(content + STL_HEADER + STL_RECORD * k + STL_NORMAL + 4 * c);
            if (!isfinite(mesh->corner[k][c]))
                return error_set(error, ERROR_USER, "%s: triangle %zu: corner %zu is not finite", path, k + 1,
                                 c / 3 + 1);
        }
    return true;
}

/* The reader of an ASCII file between two lines. */
struct stl_text {
    char *text, *line; /* the rest; the line at hand without leading blanks */
    size_t number;
    const char *path;
};

/* Moves on to the next line that is not empty; false at the end. */
static bool stl_next(struct stl_text *t) {
    while ((t->line = numbers_line(&t->text)) != NULL) {
        t->number++;
        t->line += strspn(t->line, " \t\r");
        if (*t->line != '\0')
            return true;
    }
    return false;
}

/* True if the line begins with these words; moves behind them. */
static bool stl_take(struct stl_text *t, const char *words) {
    char *at = t->line;
    while (*words) {
        size_t length = strcspn(words, " ");
        if (strncasecmp(at, words, length) != 0 || (at[length] != '\0' && !strchr(" \t\r", at[length])))
            return false;
        at += length;
        at += strspn(at, " \t\r");
        words += length + (words[length] == ' ');
    }
    t->line = at;
    return true;
}

/* The next line must begin with these words. */
static bool stl_expect(struct stl_text *t, const char *words, struct error *error) {
    if (!stl_next(t))
        return error_set(error, ERROR_USER, "%s:%zu: truncated: the file ends where '%s' should follow",
                         t->path, t->number, words);
    return stl_take(t, words) || error_set(error, ERROR_USER, "%s:%zu: '%.*s' where '%s' should be", t->path,
                                           t->number, (int)strcspn(t->line, " \t\r"), t->line, words);
}

static bool stl_vertex(struct stl_text *t, double x[3], struct error *error) {
    if (!stl_expect(t, "vertex", error))
        return false;
    for (int d = 0; d < 3; d++) {
        if (!numbers_word(&t->line, &x[d]))
            return error_set(error, ERROR_USER, "%s:%zu: a vertex needs three numbers", t->path, t->number);
        if (!isfinite(x[d]))
            return error_set(error, ERROR_USER, "%s:%zu: a coordinate is not finite", t->path, t->number);
    }
    return t->line[strspn(t->line, " \t\r")] == '\0' ||
           error_set(error, ERROR_USER, "%s:%zu: more than three numbers at a vertex", t->path, t->number);
}

/* The rest of a triangle, whose line `facet` was read. */
static bool stl_facet(struct stl_text *t, double corner[9], struct error *error) {
    if (!stl_expect(t, "outer loop", error))
        return false;
    for (int v = 0; v < 3; v++)
        if (!stl_vertex(t, corner + 3 * v, error))
            return false;
    return stl_expect(t, "endloop", error) && stl_expect(t, "endfacet", error);
}

bool mesh_stl_ascii(struct mesh *mesh, char *text, const char *path, struct error *error) {
    struct stl_text t = {.text = text, .path = path};
    bool inside = false;
    while (stl_next(&t)) {
        if (stl_take(&t, inside ? "endsolid" : "solid")) {
            inside = !inside;
            continue;
        }
        if (!inside || !stl_take(&t, "facet"))
            return error_set(error, ERROR_USER, "%s:%zu: '%.*s' where %s should be", path, t.number,
                             (int)strcspn(t.line, " \t\r"), t.line,
                             inside ? "'facet' or 'endsolid'" : "'solid'");
        if (!stl_facet(&t, mesh_add(mesh, t.number), error))
            return false;
    }
    return !inside || error_set(error, ERROR_USER, "%s:%zu: truncated: the file ends without 'endsolid'",
                                path, t.number);
}
