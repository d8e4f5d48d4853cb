/* SPDX-License-Identifier: BSD-3-Clause */
/* The vertices and faces of a PLY file. Read mesh.h first.
 *
 * The header names elements, how many there are of each, and their properties; the body has the values in this order.
 * ASCII: a line an element. Binary: the bytes of the values, one behind the other. A property is a number, or a list of
 * numbers with the count before it. Elements and properties without meaning for a mesh are read over. */
#include "physics/grains/walls/mesh.h"
#include "base/lines.h"
#include "base/numbers.h"
#include "base/memory.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PLY_ELEMENTS = 32, PLY_PROPERTIES = 64, PLY_WORDS = 5 };

enum ply_type {
    PLY_NONE,
    PLY_INT8,
    PLY_UINT8,
    PLY_INT16,
    PLY_UINT16,
    PLY_INT32,
    PLY_UINT32,
    PLY_FLOAT,
    PLY_DOUBLE
};

static const struct ply_name {
    const char *name, *other;
    size_t bytes;
} ply_names[] = {[PLY_NONE] = {"", "", 0},
                 [PLY_INT8] = {"char", "int8", 1},
                 [PLY_UINT8] = {"uchar", "uint8", 1},
                 [PLY_INT16] = {"short", "int16", 2},
                 [PLY_UINT16] = {"ushort", "uint16", 2},
                 [PLY_INT32] = {"int", "int32", 4},
                 [PLY_UINT32] = {"uint", "uint32", 4},
                 [PLY_FLOAT] = {"float", "float32", 4},
                 [PLY_DOUBLE] = {"double", "float64", 8}};

/* What a property is to a mesh. */
enum ply_role { PLY_OTHER, PLY_X, PLY_Y, PLY_Z, PLY_CORNERS };

struct ply_property {
    enum ply_type type, count; /* of the values; of the count of a list, PLY_NONE: one value, no list */
    enum ply_role role;
};

struct ply_element {
    char name[64]; /* cut off where it is longer */
    int64_t rows;
    int properties;
    struct ply_property property[PLY_PROPERTIES];
};

struct ply {
    const char *path;
    char *at, *end;      /* the rest of the file */
    size_t line;         /* number of the last line, from 1 (header, ASCII) */
    char *row;           /* ASCII: the rest of the line at hand */
    bool ascii, swap;    /* swap: the byte order is not that of this machine */
    const char *element; /* binary: the element at hand, and its number, from 1 */
    int64_t number;
    double (*point)[3];
    int64_t points;
    int elements;
    struct ply_element table[PLY_ELEMENTS];
};

bool mesh_is_ply(const char *content) {
    return strncmp(content, "ply", 3) == 0 && (content[3] == '\n' || content[3] == '\r');
}

/* Sets a user's error with the place; returns false. */
static bool __attribute__((format(printf, 3, 4)))
ply_refuse(const struct ply *t, struct error *error, const char *format, ...) {
    char text[512];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return t->element ? error_set(error, ERROR_USER, "%s: %s %lld: %s", t->path, t->element,
                                  (long long)t->number, text)
                      : error_set(error, ERROR_USER, "%s:%zu: %s", t->path, t->line, text);
}

static enum ply_type ply_type(const char *word) {
    for (int k = PLY_INT8; k <= PLY_DOUBLE; k++)
        if (strcmp(word, ply_names[k].name) == 0 || strcmp(word, ply_names[k].other) == 0)
            return (enum ply_type)k;
    return PLY_NONE;
}

/* What the property of this name is in this element. */
static enum ply_role ply_role(const char *element, const char *name) {
    if (strcmp(element, "vertex") == 0 && strlen(name) == 1 && name[0] >= 'x' && name[0] <= 'z')
        return (enum ply_role)(PLY_X + (name[0] - 'x'));
    bool corners = strcmp(name, "vertex_indices") == 0 || strcmp(name, "vertex_index") == 0;
    return strcmp(element, "face") == 0 && corners ? PLY_CORNERS : PLY_OTHER;
}

/* `format ascii 1.0` */
static bool ply_format(struct ply *t, char **word, int words, struct error *error) {
    static const uint16_t one = 1;
    bool little_here = *(const unsigned char *)&one == 1;
    bool little = words == 3 && strcmp(word[1], "binary_little_endian") == 0;
    bool big = words == 3 && strcmp(word[1], "binary_big_endian") == 0;
    t->ascii = words == 3 && strcmp(word[1], "ascii") == 0;
    t->swap = little_here ? big : little;
    return ((t->ascii || little || big) && strcmp(word[2], "1.0") == 0) ||
           ply_refuse(t, error,
                      "no format of a PLY file; known: ascii 1.0, binary_little_endian 1.0, "
                      "binary_big_endian 1.0");
}

/* `element NAME ROWS` */
static bool ply_element(struct ply *t, char **word, int words, struct error *error) {
    if (t->elements == PLY_ELEMENTS)
        return ply_refuse(t, error, "more than %d elements", PLY_ELEMENTS);
    struct ply_element *e = &t->table[t->elements++];
    snprintf(e->name, sizeof e->name, "%s", words > 1 ? word[1] : "");
    return (words == 3 && lines_integer(word[2], &e->rows) && e->rows >= 0 && e->rows <= UINT32_MAX) ||
           ply_refuse(t, error, "an element needs a name and how many there are, 0 to %u", UINT32_MAX);
}

/* `property TYPE NAME` or `property list TYPE TYPE NAME` */
static bool ply_property(struct ply *t, char **word, int words, struct error *error) {
    if (t->elements == 0)
        return ply_refuse(t, error, "a property before the first element");
    struct ply_element *e = &t->table[t->elements - 1];
    if (e->properties == PLY_PROPERTIES)
        return ply_refuse(t, error, "more than %d properties of an element", PLY_PROPERTIES);
    struct ply_property *p = &e->property[e->properties++];
    bool list = words == 5 && strcmp(word[1], "list") == 0;
    if (!list && words != 3)
        return ply_refuse(t, error, "a property needs a type and a name, or list, two types and a name");
    *p = (struct ply_property){ply_type(word[words - 2]), list ? ply_type(word[2]) : PLY_NONE,
                               ply_role(e->name, word[words - 1])};
    if (p->type == PLY_NONE || (list && (p->count == PLY_NONE || p->count >= PLY_FLOAT)))
        return ply_refuse(t, error,
                          "an unknown type; known: char, uchar, short, ushort, int, uint, and for values "
                          "float, double");
    if (p->role == PLY_CORNERS ? !list || p->type >= PLY_FLOAT : p->role != PLY_OTHER && list)
        return ply_refuse(t, error, "'%s' must be %s", word[words - 1],
                          p->role == PLY_CORNERS ? "a list of whole numbers" : "a number");
    for (int k = 0; p->role != PLY_OTHER && k < e->properties - 1; k++)
        if (e->property[k].role == p->role)
            return ply_refuse(t, error, "a second '%s'", word[words - 1]);
    return true;
}

/* The element of this name, with a property of each role up to `last`; -1 with an error if there is none. */
static int ply_find(const struct ply *t, const char *name, enum ply_role first, enum ply_role last,
                    struct error *error) {
    for (int k = 0; k < t->elements; k++) {
        int found = 0;
        for (int p = 0; p < t->table[k].properties; p++)
            found += t->table[k].property[p].role >= first && t->table[k].property[p].role <= last;
        if (strcmp(t->table[k].name, name) == 0 && found == (int)(last - first) + 1)
            return k;
    }
    error_set(error, ERROR_USER, "%s: no element '%s' with %s in the header of the PLY file", t->path, name,
              first == PLY_X ? "x, y and z" : "a list 'vertex_indices'");
    return -1;
}

/* What the elements must be for a mesh. */
static bool ply_check(const struct ply *t, struct error *error) {
    for (int k = 0; k < t->elements; k++) {
        if (t->table[k].properties == 0 && t->table[k].rows > 0)
            return error_set(error, ERROR_USER, "%s: the element '%s' has no property", t->path,
                             t->table[k].name);
        for (int other = 0; other < k; other++)
            if (strcmp(t->table[k].name, t->table[other].name) == 0)
                return error_set(error, ERROR_USER, "%s: a second element '%s'", t->path, t->table[k].name);
    }
    int vertex = ply_find(t, "vertex", PLY_X, PLY_Z, error);
    int face = vertex < 0 ? -1 : ply_find(t, "face", PLY_CORNERS, PLY_CORNERS, error);
    return face >= 0 &&
           (vertex < face ||
            error_set(error, ERROR_USER, "%s: the element 'face' stands before 'vertex'", t->path));
}

/* The next line of the header or of an ASCII body, without leading blanks; NULL at the end. */
static char *ply_line(struct ply *t) {
    char *line = t->at < t->end ? numbers_line(&t->at) : NULL;
    t->line += line != NULL;
    return line ? line + strspn(line, " \t") : NULL;
}

static bool ply_header(struct ply *t, struct error *error) {
    bool format = false;
    for (char *line; (line = ply_line(t)) != NULL;) {
        char *word[PLY_WORDS + 1], *rest = line;
        int words = 0;
        while (words <= PLY_WORDS && (word[words] = strtok_r(rest, " \t\r", &rest)) != NULL)
            words++;
        const char *first = words > 0 ? word[0] : "";
        bool good = t->line == 1 ? strcmp(first, "ply") == 0 && words == 1 : true;
        if (t->line == 1 || strcmp(first, "comment") == 0 || strcmp(first, "obj_info") == 0)
            ;
        else if (!format)
            format = good = strcmp(first, "format") == 0 && ply_format(t, word, words, error);
        else if (strcmp(first, "element") == 0)
            good = ply_element(t, word, words, error);
        else if (strcmp(first, "property") == 0)
            good = ply_property(t, word, words, error);
        else if (strcmp(first, "end_header") == 0 && words == 1)
            return ply_check(t, error);
        else
            good = false;
        if (!good)
            return ply_refuse(t, error, "'%.40s' where %s should be", first,
                              t->line == 1 ? "'ply'"
                              : format     ? "'element', 'property', 'comment' or 'end_header'"
                                           : "'format'");
    }
    return ply_refuse(t, error, "truncated: the file ends within the header of the PLY file");
}

/* Reads the bytes of a value. */
static double ply_bytes(const struct ply *t, enum ply_type type) {
    unsigned char b[8];
    size_t bytes = ply_names[type].bytes;
    union {
        int8_t int8;
        uint8_t uint8;
        int16_t int16;
        uint16_t uint16;
        int32_t int32;
        uint32_t uint32;
        float real;
        double wide;
    } v = {.wide = 0};
    for (size_t k = 0; k < bytes; k++)
        b[k] = (unsigned char)t->at[t->swap ? bytes - 1 - k : k];
    memcpy(&v, b, bytes);
    switch (type) {
    case PLY_INT8:
        return v.int8;
    case PLY_UINT8:
        return v.uint8;
    case PLY_INT16:
        return v.int16;
    case PLY_UINT16:
        return v.uint16;
    case PLY_INT32:
        return v.int32;
    case PLY_UINT32:
        return v.uint32;
    case PLY_FLOAT:
        return (double)v.real;
    default:
        return v.wide;
    }
}

/* The next value of the body. */
static bool ply_value(struct ply *t, enum ply_type type, double *value, struct error *error) {
    if (!t->ascii) {
        if ((size_t)(t->end - t->at) < ply_names[type].bytes)
            return ply_refuse(t, error, "truncated: the file ends before all that its header names");
        *value = ply_bytes(t, type);
        t->at += ply_names[type].bytes;
        return true;
    }
    t->row += strspn(t->row, " \t\r");
    if (!numbers_word(&t->row, value))
        return ply_refuse(t, error, "'%.40s' where a number should be", t->row);
    return type >= PLY_FLOAT || *value == nearbyint(*value) ||
           ply_refuse(t, error, "%g where a whole number should be", *value);
}

/* The count and the values of a list; the values are kept if they are the corners of a face. */
static bool ply_list(struct ply *t, const struct ply_property *p, struct mesh *mesh, struct error *error) {
    uint32_t corner[MESH_CORNERS_MAX];
    double count, value;
    bool face = p->role == PLY_CORNERS;
    if (!ply_value(t, p->count, &count, error))
        return false;
    if (face && !(count >= 3 && count <= MESH_CORNERS_MAX))
        return ply_refuse(t, error, "a face of %g corners; allowed: 3 to %d", count, MESH_CORNERS_MAX);
    if (!(count >= 0 && count <= UINT32_MAX))
        return ply_refuse(t, error, "a list of %g values", count);
    for (int64_t k = 0; k < (int64_t)count; k++) {
        if (!ply_value(t, p->type, &value, error))
            return false;
        if (face && !(value >= 0 && value < (double)t->points))
            return ply_refuse(t, error, "%.10g is no vertex of this face; allowed: 0 to %lld", value,
                              (long long)t->points - 1);
        if (face)
            corner[k] = (uint32_t)value;
    }
    if (face)
        mesh_add_polygon(mesh, t->point, corner, (int)count, t->ascii ? t->line : 0);
    return true;
}

/* Moves to the line of the next row of an ASCII body. */
static bool ply_next(struct ply *t, const char *element, int64_t row, int64_t rows, struct error *error) {
    do
        t->row = ply_line(t);
    while (t->row != NULL && t->row[strspn(t->row, " \t\r")] == '\0');
    return t->row != NULL ||
           ply_refuse(t, error, "truncated: the file ends behind %lld of the %lld rows of '%s'",
                      (long long)row, (long long)rows, element);
}

/* One row of an element. */
static bool ply_row(struct ply *t, const struct ply_element *e, struct mesh *mesh, struct error *error) {
    double x[3] = {0}, value;
    bool vertex = false;
    for (int k = 0; k < e->properties; k++) {
        const struct ply_property *p = &e->property[k];
        bool good = p->count != PLY_NONE ? ply_list(t, p, mesh, error) : ply_value(t, p->type, &value, error);
        if (!good)
            return false;
        if (p->role < PLY_X || p->role > PLY_Z)
            continue;
        vertex = true;
        x[p->role - PLY_X] = value;
        if (!isfinite(value))
            return ply_refuse(t, error, "a coordinate is not finite");
    }
    if (vertex)
        memcpy(t->point[t->points++], x, sizeof x);
    return !t->ascii || t->row[strspn(t->row, " \t\r")] == '\0' ||
           ply_refuse(t, error, "more numbers than the header names");
}

static bool ply_body(struct ply *t, struct mesh *mesh, struct error *error) {
    for (int k = 0; k < t->elements; k++) {
        const struct ply_element *e = &t->table[k];
        if (e->rows > t->end - t->at) /* a row has a byte or more */
            return ply_refuse(t, error, "truncated: %lld rows of '%s', as the header says, and %lld bytes",
                              (long long)e->rows, e->name, (long long)(t->end - t->at));
        if (strcmp(e->name, "vertex") == 0)
            t->point = memory_allocate((size_t)e->rows, sizeof *t->point, "vertices of a mesh");
        for (int64_t row = 0; row < e->rows; row++) {
            t->element = t->ascii ? NULL : e->name;
            t->number = row + 1;
            if ((t->ascii && !ply_next(t, e->name, row, e->rows, error)) || !ply_row(t, e, mesh, error))
                return false;
        }
        t->element = NULL;
    }
    while (t->ascii && (t->row = ply_line(t)) != NULL)
        if (t->row[strspn(t->row, " \t\r")] != '\0')
            return ply_refuse(t, error, "too long: the file goes on behind all that its header names");
    return t->at >= t->end ||
           error_set(error, ERROR_USER, "%s: too long: %lld bytes behind all that its header names", t->path,
                     (long long)(t->end - t->at));
}

bool mesh_ply(struct mesh *mesh, char *content, size_t size, const char *path, struct error *error) {
    struct ply *t = memory_allocate_zero(1, sizeof *t, "header of a mesh");
    t->path = path;
    t->at = content;
    t->end = content + size;
    bool good = ply_header(t, error) && ply_body(t, mesh, error);
    good = good && (mesh->count > 0 || error_set(error, ERROR_USER, "%s: no face in the PLY file", path));
    memory_free(t->point);
    memory_free(t);
    return good;
}
