/* SPDX-License-Identifier: BSD-3-Clause */
/* Reading of meshes: what is accepted, and what is refused with which place. */
#include "tests/test.h"

#include "physics/grains/walls/mesh.h"
#include "physics/grains/walls/wall.h"
#include "base/numbers.h"
#include "base/memory.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/walls_by_hand.h"

static const char ascii_two[] = "solid  two words\n"
                                " facet normal nan nan nan\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
                                "   vertex 0 1e0 0\n  endloop\n endfacet\n\n"
                                " FACET normal 0 0 1\n  OUTER LOOP\n   VERTEX 1 0 0\n   vertex 1 1 0\n"
                                "   vertex 0 1 -0.5\n  endloop\n endfacet\nendsolid two words\n";

/* Reads a text; returns success. */
static bool read_text(struct mesh *mesh, const char *text, size_t size, const char *format, char why[256]) {
    char path[64];
    struct error error = {0};
    hand_file(path, "mesh", text, size);
    bool good = mesh_read(mesh, path, format, &error);
    remove(path);
    assert_int_equal(error.kind, good ? ERROR_NONE : ERROR_USER);
    const char *colon = strchr(error.text, ':');
    snprintf(why, 256, "%.255s", colon ? colon : error.text);
    return good;
}

static void must_read(struct mesh *mesh, const char *text, size_t size, const char *format) {
    char why[256];
    if (!read_text(mesh, text, size, format, why))
        fail_msg("%s", why);
}

/* The text must be refused, and the message hold these words. */
static void must_refuse(const char *text, size_t size, const char *format, const char *words) {
    struct mesh mesh;
    char why[256];
    if (read_text(&mesh, text, size, format, why))
        fail_msg("accepted: %s", words);
    if (strstr(why, words) == NULL)
        fail_msg("'%s' lacks '%s'", why, words);
    assert_null(mesh.corner);
}

static void refuse(const char *text, const char *format, const char *words) {
    must_refuse(text, strlen(text), format, words);
}

/* The sum of the areas of the triangles. */
static double area_of(const struct mesh *mesh) {
    double area = 0.0;
    for (size_t t = 0; t < mesh->count; t++)
        area += wall_surface_area(mesh->corner[t]);
    return area;
}

static void test_obj(void **state) {
    static const char text[] = "# a square and a triangle\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0.0\nv 0 0 3\n"
                               "f 1 2 3 4\nf 1 2 5\n";
    static const char slashes[] =
        "# turned\no a\nv 0.1 0 0 1\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nusemtl no\nf -3/1/1 -2//1 -1\n";
    struct mesh mesh;
    (void)state;
    must_read(&mesh, text, strlen(text), "");
    assert_int_equal(mesh.count, 3);
    assert_int_equal(mesh.line[1], 7);
    assert_near(area_of(&mesh), 5.0, 1e-12);
    mesh_free(&mesh);
    must_read(&mesh, slashes, strlen(slashes), "");
    assert_int_equal(mesh.count, 1);
    assert_true(mesh.corner[0][0] == 0.1); /* no digit is lost */
    mesh_free(&mesh);
    refuse("v 0 0 0\n", "obj", "OBJ");
    refuse("mtllib m\nv 0 0\n", "", ":2: an OBJ vertex needs three");
    refuse("v 0 0 0\nfacet n 0\nf 1 1 2\n", "obj", ":3: '2' is no vertex");
    refuse("v 0 0 0\nf -1 -2 1\n", "obj", ":2: '-2' is no vertex");
    refuse("v 0 0 0\nf 1x 1 1\n", "obj", ":2: '1x' is no vertex");
    refuse("v 0 0 0\nv 1 0 0\nf 1 2\n", "obj", ":3: an OBJ face of 2 corners");
}

/* Polygons that bend inwards, in any plane and turned either way, keep their area and their sense; one that crosses itself
 * ends, too. */
static void test_polygons(void **state) {
    static const double comb[12][2] = {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1},
                                       {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
    (void)state;
    for (int turn = 0; turn < 6; turn++) {
        double point[12][3];
        uint32_t corner[12];
        double sum = 0.0;
        struct mesh mesh = {0};
        int axis = turn % 3;
        for (uint32_t k = 0; k < 12; k++) {
            point[k][axis] = 1e3 + 0.5 * comb[k][0];
            point[k][(axis + 1) % 3] = comb[k][0];
            point[k][(axis + 2) % 3] = comb[k][1];
            corner[k] = turn < 3 ? k : 11 - k;
        }
        mesh_add_polygon(&mesh, point, corner, 12, 0);
        assert_int_equal(mesh.count, 10);
        assert_null(mesh.line);
        for (size_t t = 0; t < mesh.count; t++) {
            const double *x = mesh.corner[t];
            int e = (axis + 1) % 3, f = (axis + 2) % 3;
            double area = ((x[3 + e] - x[e]) * (x[6 + f] - x[f]) - (x[3 + f] - x[f]) * (x[6 + e] - x[e])) / 2;
            assert_true(turn < 3 ? area >= 0 : area <= 0);
            sum += area;
        }
        assert_near(fabs(sum), 11.0, 1e-9);
        mesh_free(&mesh);
    }
    static const double crossed[5][3] = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    static const uint32_t all[5] = {0, 1, 2, 3, 4}, same[5] = {0};
    struct mesh mesh = {0};
    mesh_add_polygon(&mesh, crossed, all, 5, 3);
    mesh_add_polygon(&mesh, crossed, same, 5, 4);
    assert_int_equal(mesh.count, 6);
    assert_int_equal(mesh.line[5], 4);
    mesh_free(&mesh);
}

/* Makes a binary STL file of n triangles; corner c of triangle k is k + c / 4. */
static size_t binary(char *out, uint32_t n, const char *header) {
    memset(out, 0, 84 + 50 * (size_t)n);
    memcpy(out, header, strlen(header));
    memcpy(out + 80, &n, 4);
    for (uint32_t k = 0; k < n; k++)
        for (int c = 0; c < 9; c++) {
            float x = (float)k + 0.25f * (float)c;
            memcpy(out + 84 + 50 * k + 12 + 4 * c, &x, 4);
        }
    return 84 + 50 * (size_t)n;
}

static void test_ascii(void **state) {
    (void)state;
    struct mesh mesh;
    const char *const formats[] = {"stl", "", "auto"};
    for (int k = 0; k < 3; k++) {
        must_read(&mesh, ascii_two, strlen(ascii_two), formats[k]);
        assert_int_equal(mesh.count, 2);
        assert_true(mesh.corner[0][7] == 1.0 && mesh.corner[1][8] == -0.5);
        assert_int_equal(mesh.line[0], 2);
        assert_int_equal(mesh.line[1], 10);
        mesh_free(&mesh);
    }
}

static void test_ascii_returns(void **state) {
    (void)state;
    struct mesh mesh;
    char text[2 * sizeof ascii_two], *out = text;
    for (const char *c = ascii_two; *c; c++) {
        if (*c == '\n')
            *out++ = '\r';
        *out++ = *c;
    }
    must_read(&mesh, text, (size_t)(out - text), "");
    assert_int_equal(mesh.count, 2);
    mesh_free(&mesh);
}

static void test_binary(void **state) {
    (void)state;
    struct mesh mesh;
    char content[84 + 500];
    for (int solid = 0; solid < 2; solid++) {
        size_t size = binary(content, 7, solid ? "solid but binary" : "made by a test");
        must_read(&mesh, content, size, solid ? "" : "stl");
        assert_int_equal(mesh.count, 7);
        assert_null(mesh.line);
        assert_true(mesh.corner[6][8] == 8.0);
        mesh_free(&mesh);
    }
}

static void test_table(void **state) {
    (void)state;
    struct mesh mesh;
    const char *const text[] = {"1 2 3 4 5 6 7 8 9\n9 8 7 6 5 4 3 2 1\n",
                                "v1_x[m] v1_y[m]\r\n\r\n1 2 3 4 5 6 7 8 9\r\n9 8 7 6 5 4 3 2 1",
                                "# by hand\n\t1,2,3;4,5,6;7,8,9\n9 8 7 6 5 4 3 2 1  \n"};
    const uint32_t line[] = {2, 4, 3};
    for (int k = 0; k < 3; k++) {
        must_read(&mesh, text[k], strlen(text[k]), k == 1 ? "table" : "");
        assert_int_equal(mesh.count, 2);
        assert_int_equal(mesh.line[1], line[k]);
        for (int c = 0; c < 9; c++) {
            assert_true(mesh.corner[0][c] == c + 1);
            assert_true(mesh.corner[1][c] == 9 - c);
        }
        mesh_free(&mesh);
    }
}

static void test_bad_tables(void **state) {
    (void)state;
    refuse("", "", "the file is empty");
    refuse("x y z\n", "", "no triangle");
    refuse("# nothing\n\n", "table", "no triangle");
    refuse("1 2 3 4 5 6 7 8\n", "", ":1: 8 numbers, 9 are needed");
    refuse("a b\n1 2 3 4 5 6 7 8 9\n1 2 3 4 5 6 7 8 9 10\n", "", ":3: 10 numbers");
    refuse("a b\n1 2 3 4 5 6 7 8 9\n\nc d\n", "", ":4: not a number: 'c'");
    refuse("1 2 3 4 5 6 7 8 9x\n", "", ":1: not a number: '9x'");
    refuse("1 2 3 4 nan 6 7 8 9\n", "", ":1: not a finite number: 'nan'");
    refuse("1 2 3 4 5 6 7 8 1e999\n", "", ":1: not a finite number: '1e999'");
    must_refuse("1 2 3 4 5\0 6 7 8 9\n", 20, "table", "byte 9 is zero");
    refuse("1 2 3 4 5 6 7 8 9\n", "vrml", "unknown mesh format 'vrml'; known: auto, stl, obj, ply, table");
}

static void test_bad_ascii(void **state) {
    (void)state;
    char text[sizeof ascii_two];
    refuse("solid nothing\nendsolid\n", "", "no triangle");
    refuse("1 2 3 4 5 6 7 8 9\n", "stl", ":1: '1' where 'solid' should be");
    refuse("solid\nvertex 0 0 0\n", "", ":2: 'vertex' where 'facet' or 'endsolid' should be");
    refuse("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", "", ":4: a vertex needs three numbers");
    refuse("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0 0\n", "", ":4: more than three");
    refuse("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 inf 0\n", "", ":4: a coordinate is not finite");
    refuse("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n", "",
           ":5: 'endloop' where 'vertex' should be");
    refuse("solid\nfacet normal 0 0 1\nvertex 0 0 0\n", "", ":3: 'vertex' where 'outer loop' should be");
    /* cut at any line, the file is refused */
    for (size_t end = 0; end + 1 < strlen(ascii_two); end++) {
        if (ascii_two[end] != '\n' || end + 1 == strlen(ascii_two))
            continue;
        memcpy(text, ascii_two, end + 1);
        must_refuse(text, end + 1, "", "truncated");
    }
}

static void test_bad_binary(void **state) {
    (void)state;
    char content[84 + 500];
    size_t size = binary(content, 4, "a header");
    must_refuse(content, size - 1, "",
                "truncated: 4 triangles, as it says, take 284 bytes, the file has 283");
    must_refuse(content, 84, "", "truncated");
    must_refuse(content, 20, "stl", "truncated: 20 bytes");
    must_refuse(content, size + 1, "stl", "too long");
    uint32_t many = 0xffffffffu;
    memcpy(content + 80, &many, 4);
    must_refuse(content, size, "stl", "truncated: 4294967295 triangles");
    size = binary(content, 0, "none");
    must_refuse(content, size, "", "no triangle");
    size = binary(content, 4, "a header");
    memset(content + 84 + 50 * 2 + 12 + 4 * 5, 0xff, 4);
    must_refuse(content, size, "", "triangle 3: corner 2 is not finite");
}

static void test_no_file(void **state) {
    (void)state;
    struct mesh mesh;
    struct error error = {0};
    assert_false(mesh_read(&mesh, "no/such/file.stl", "", &error));
    assert_int_equal(error.kind, ERROR_USER);
    assert_non_null(strstr(error.text, "no/such/file.stl: cannot be opened: "));
    assert_false(mesh_read(&mesh, ".", "", &(struct error){0}));
}

static void test_numbers(void **state) {
    (void)state;
    struct numbers numbers;
    struct error error = {0};
    char path[64];
    hand_file(path, "numbers", "t x\n0 1\n2 3\n", 12);
    assert_true(numbers_read(&numbers, path, 2, &error));
    assert_int_equal(numbers.rows, 2);
    assert_true(numbers.value[3] == 3.0);
    numbers_free(&numbers);
    assert_false(numbers_read(&numbers, path, 3, &error));
    assert_non_null(strstr(error.text, ":2: 2 numbers, 3 are needed"));
    remove(path);
}

TEST_MAIN(mesh, cmocka_unit_test(test_ascii), cmocka_unit_test(test_ascii_returns),
          cmocka_unit_test(test_binary), cmocka_unit_test(test_table), cmocka_unit_test(test_bad_tables),
          cmocka_unit_test(test_bad_ascii), cmocka_unit_test(test_bad_binary), cmocka_unit_test(test_no_file),
          cmocka_unit_test(test_obj), cmocka_unit_test(test_polygons), cmocka_unit_test(test_numbers))
