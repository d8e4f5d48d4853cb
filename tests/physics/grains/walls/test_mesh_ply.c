/* SPDX-License-Identifier: BSD-3-Clause */
/* Reading of PLY files: every form of the same square, and what is refused with which place. */
#include "tests/test.h"

#include "physics/grains/walls/mesh.h"
#include "physics/grains/walls/wall.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/walls_by_hand.h"

static const char square_head[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
    "end_header\n";
static const char square[] = "0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 1 2 3\n";

/* Reads a content; returns success. */
static bool read_content(struct mesh *mesh, const char *content, size_t size, char why[256]) {
    char path[64];
    struct error error = {0};
    hand_file(path, "mesh", content, size);
    bool good = mesh_read(mesh, path, "", &error);
    remove(path);
    assert_int_equal(error.kind, good ? ERROR_NONE : ERROR_USER);
    const char *colon = strchr(error.text, ':');
    snprintf(why, 256, "%.255s", colon ? colon : error.text);
    return good;
}

static void must_refuse(const char *content, size_t size, const char *words) {
    struct mesh mesh;
    char why[256];
    if (read_content(&mesh, content, size, why))
        fail_msg("accepted: %s", words);
    if (strstr(why, words) == NULL)
        fail_msg("'%s' lacks '%s'", why, words);
    assert_null(mesh.corner);
}

/* The header of the square and this body must be refused. */
static void refuse_body(const char *body, const char *words) {
    char text[1024];
    snprintf(text, sizeof text, "%s%s", square_head, body);
    must_refuse(text, strlen(text), words);
}

/* The header of the square, with `was` replaced by `now` and its body, must be refused. */
static void refuse_head(const char *was, const char *now, const char *words) {
    char text[1024];
    const char *at = strstr(square_head, was);
    assert_non_null(at);
    snprintf(text, sizeof text, "%.*s%s%s%s", (int)(at - square_head), square_head, now, at + strlen(was),
             square);
    must_refuse(text, strlen(text), words);
}

/* A binary file under construction. */
struct bytes {
    char at[4096];
    size_t size;
    bool big;
};

static void put_text(struct bytes *b, const char *text) {
    memcpy(b->at + b->size, text, strlen(text));
    b->size += strlen(text);
}

static void put(struct bytes *b, const void *value, size_t size) {
    for (size_t k = 0; k < size; k++)
        b->at[b->size + k] = ((const char *)value)[b->big ? size - 1 - k : k];
    b->size += size;
}

/* A whole number in so many bytes: the low ones, which come first on the machines that scree runs on. */
static void put_whole(struct bytes *b, int64_t value, size_t size) {
    put(b, &value, size);
}

static const struct {
    const char *name;
    size_t bytes;
} whole[] = {{"char", 1}, {"uint8", 1}, {"short", 2}, {"ushort", 2}, {"int", 4}, {"uint32", 4}};

/* The square, with elements and properties that a mesh has no use for, of these types of lists. */
static void square_binary(struct bytes *b, bool big, int count, int index, bool wide) {
    char text[64];
    *b = (struct bytes){.big = big};
    put_text(b, big ? "ply\nformat binary_big_endian 1.0\n" : "ply\nformat binary_little_endian 1.0\n");
    put_text(
        b,
        "comment element face 7\nobj_info a b c d e f g\nelement camera 1\nproperty list ushort double view\n"
        "element vertex 4\nproperty uchar red\n");
    for (int d = 0; d < 3; d++) {
        snprintf(text, sizeof text, "property %s %c\n", wide ? "double" : "float32", "xyz"[d]);
        put_text(b, text);
    }
    put_text(b, "element face 1\nproperty int flag\n");
    snprintf(text, sizeof text, "property list %s %s vertex_index\n", whole[count].name, whole[index].name);
    put_text(b, text);
    put_text(b, "property list uchar float texcoord\nend_header\n");
    double view = 1.0;
    put_whole(b, 2, 2), put(b, &view, 8), put(b, &view, 8);
    for (int k = 0; k < 4; k++) {
        put_whole(b, 200, 1);
        for (int d = 0; d < 3; d++) {
            double x = d == 0 ? 2 * (k == 1 || k == 2) : d == 1 ? k >= 2 : 0.1;
            float narrow = (float)x;
            put(b, wide ? (void *)&x : (void *)&narrow, wide ? 8 : 4);
        }
    }
    put_whole(b, -5, 4), put_whole(b, 4, whole[count].bytes);
    for (int k = 0; k < 4; k++)
        put_whole(b, k, whole[index].bytes);
    put_whole(b, 0, 1);
}

static void test_binary(void **state) {
    (void)state;
    struct bytes b;
    char why[256];
    for (int form = 0; form < 2 * 6 * 6 * 2; form++) {
        struct mesh mesh;
        bool wide = form % 2;
        square_binary(&b, form / 2 % 2, form / 4 % 6, form / 24, wide);
        if (!read_content(&mesh, b.at, b.size, why))
            fail_msg("form %d: %s", form, why);
        assert_int_equal(mesh.count, 2);
        assert_null(mesh.line);
        assert_near(wall_surface_area(mesh.corner[0]) + wall_surface_area(mesh.corner[1]), 2.0, 1e-12);
        assert_true(mesh.corner[0][2] == (wide ? 0.1 : (double)0.1f));
        mesh_free(&mesh);
    }
    /* cut at any byte, or longer, the file is refused */
    square_binary(&b, false, 0, 4, false);
    size_t head = (size_t)(strstr(b.at, "end_header") - b.at) + strlen("end_header");
    for (size_t size = 4; size < b.size; size++)
        must_refuse(b.at, size, size < head ? "" : "truncated");
    b.at[b.size] = '\n';
    must_refuse(b.at, b.size + 1, "too long: 1 bytes");
    for (int k = 0; k < 2; k++) { /* a corner beyond, or before, the vertices */
        square_binary(&b, k, 1, 4, false);
        b.size -= 5;
        put_whole(&b, k ? -1 : 3000000, 4), put_whole(&b, 0, 1);
        must_refuse(b.at, b.size,
                    k ? ": face 1: -1 is no vertex of this face; allowed: 0 to 3"
                      : ": face 1: 3000000 is no vertex of this face; allowed: 0 to 3");
    }
}

static void test_ascii(void **state) {
    (void)state;
    char text[1024], why[256];
    struct mesh mesh;
    for (int form = 0; form < 3; form++) { /* either end of a line, and none at the end */
        const char *const part[2] = {square_head, square};
        size_t size = 0;
        for (int k = 0; k < 2; k++)
            for (const char *c = part[k]; *c; c++) {
                if (*c == '\n' && form == 1)
                    text[size++] = '\r';
                text[size++] = *c;
            }
        size -= form == 2;
        if (!read_content(&mesh, text, size, why))
            fail_msg("form %d: %s", form, why);
        assert_int_equal(mesh.count, 2);
        assert_int_equal(mesh.line[1], 14);
        mesh_free(&mesh);
    }
}

static void test_bad_bodies(void **state) {
    (void)state;
    refuse_body("0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 1 2 3 4\n",
                ":14: 4 is no vertex of this face; allowed: 0 to 3");
    refuse_body("0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 1 2 -1\n", ":14: -1 is no vertex");
    refuse_body("0 0 0\n2 0 0\n2 1 0\n0 1 0\n0\n", ":14: a face of 0 corners; allowed: 3 to 1024");
    refuse_body("0 0 0\n2 0 0\n2 1 0\n0 1 0\n-1e308 4 5 6\n", ":14: a face of -1e+308 corners");
    refuse_body("0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 1 2\n", ":14: '' where a number should be");
    refuse_body("0 0 0\n2 0 0\n2 1 0\n0 1 0\n3 0 1 2 3\n", ":14: more numbers than the header names");
    refuse_body("0 0 0\n2 0 0\n2 1 0\n0 1 0\n3 0 1 1.5\n", ":14: 1.5 where a whole number should be");
    refuse_body("0 0 0\n2 0 0\n2 1 0\n0 1 0\n", "truncated: 1 rows of 'face'");
    refuse_body("0 0 0\n2 0 0\n2 1 0\n0 1 0\n\n\n",
                "truncated: the file ends behind 0 of the 1 rows of 'face'");
    refuse_body("0 0 0\n2 0 0\n2 1 0 0 1 0\n4 0 1 2 3\n", ":12: more numbers");
    refuse_body("0 0 0\n2 0 inf\n2 1 0\n0 1 0\n4 0 1 2 3\n", ":11: a coordinate is not finite");
    refuse_body("0 0 0\n2 0 x\n2 1 0\n0 1 0\n4 0 1 2 3\n", ":11: 'x' where a number should be");
    refuse_body("0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n", "too long");
}

static void test_bad_headers(void **state) {
    (void)state;
    must_refuse("ply\nformat ascii 1.0\ne", 22,
                ":3: 'e' where 'element', 'property', 'comment' or 'end_header'");
    must_refuse("ply\n", 4, "truncated");
    refuse_head("ascii 1.0", "ascii 2.0", ":2: no format of a PLY file");
    refuse_head("format ascii 1.0\n", "", ":2: 'element' where 'format' should be");
    refuse_head("end_header", "end_\x80header", ":9: 'end_");
    refuse_head("vertex 4", "vertex 1e309", ":3: an element needs a name and how many there are");
    refuse_head("vertex 4", "vertex -4", ":3: an element needs a name");
    refuse_head("vertex 4", "vertex 400", "truncated: 400 rows of 'vertex'");
    refuse_head("element vertex 4\n", "", ":3: a property before the first element");
    refuse_head("property float z\n", "", "no element 'vertex' with x, y and z");
    refuse_head("property float z", "propert\xcf float z", ":6: 'propert");
    refuse_head("property float z", "property half z", ":6: an unknown type");
    refuse_head("property float z", "property float y", ":6: a second 'y'");
    refuse_head("property float z", "property list uchar float z", ":6: 'z' must be a number");
    refuse_head("uchar int", "uchar float", ":8: 'vertex_indices' must be a list of whole numbers");
    refuse_head("uchar int", "float int", ":8: an unknown type");
    refuse_head("list uchar int", "int", ":8: 'vertex_indices' must be a list");
    refuse_head("vertex_indices", "corners", "no element 'face' with a list 'vertex_indices'");
    refuse_head("property list uchar int vertex_indices\n", "", "the element 'face' has no property");
    refuse_head("element face 1", "element vertex 1", "a second element 'vertex'");
    refuse_head("element face 1", "element face 0", "too long");
}

TEST_MAIN(mesh_ply, cmocka_unit_test(test_binary), cmocka_unit_test(test_ascii),
          cmocka_unit_test(test_bad_bodies), cmocka_unit_test(test_bad_headers))
