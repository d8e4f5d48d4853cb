/* SPDX-License-Identifier: BSD-3-Clause */
/* Surfaces of meshes: vertices merged, patches and features found, repairs noted, triangles found by the
 * grid. */
#include "tests/test.h"

#include "physics/grains/walls/wall_grid.h"
#include "physics/grains/walls/mesh_shape.h"
#include "physics/grains/walls/wall_mesh.h"
#include "physics/grains/walls/wall_touch.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/surface_by_hand.h"

static void test_cube(void **state) {
    (void)state;
    for (int n = 1; n <= 5; n++) {
        struct hand_text t = text_new();
        text_cube(&t, 1.0, 3.0, n);
        struct wall_mesh *mesh = text_surface(&t);
        assert_int_equal(mesh->triangles, 12 * n * n);
        assert_int_equal(mesh->patches, 6);
        assert_int_equal(mesh->edges, 12 * n);
        assert_int_equal(mesh->vertices, 8 + 12 * (n - 1));
        for (size_t p = 0; p < 6; p++) {
            double far = fabs(law_dot(mesh->patch[p].normal, mesh->patch[p].point));
            assert_true(fabs(far - 1.0) < 1e-14 || fabs(far - 3.0) < 1e-14);
        }
        assert_near(mesh->radius, sqrt(3.0), 1e-14);
        wall_mesh_destroy(&mesh);
        assert_null(mesh);
    }
}

/* The surface of a shape, and its area. */
static struct wall_mesh *shape_surface(const struct wall_options *options, double *area) {
    struct wall_mesh_place place = {.scale = 1.0};
    struct wall_mesh *mesh;
    struct mesh file;
    struct error error = {0};
    if (!mesh_shape_make(&file, options, &error) ||
        !wall_mesh_create(&mesh, &file, "shape", &place, NULL, &error))
        fail_msg("%s", error.text);
    *area = 0.0;
    for (size_t k = 0; k < file.count; k++)
        *area += wall_surface_area(file.corner[k]);
    mesh_free(&file);
    return mesh;
}

/* Distance from x to the nearest triangle. */
static double shape_distance(const struct wall_mesh *mesh, double x, double y, double z) {
    double least = INFINITY;
    for (size_t t = 0; t < mesh->triangles; t++)
        least =
            fmin(least, wall_touch_nearest(mesh, (int32_t)t, (struct law_vector){x, y, z}, 100.0).distance);
    return least;
}

/* Shapes against closed forms: area, patches, open edges, distances. */
static void test_shapes(void **state) {
    (void)state;
    double area;
    struct wall_options box = {.shape = WALL_BOX, .lower = {-1, 0, 1}, .upper = {1, 3, 2}};
    struct wall_mesh *mesh = shape_surface(&box, &area);
    assert_near(area, 2.0 * (2 * 3 + 3 * 1 + 1 * 2), 1e-13);
    assert_int_equal(mesh->patches, 6);
    assert_int_equal(wall_mesh_open_edges(mesh, true), 0);
    for (size_t p = 0; p < 6; p++) /* outwards */
        assert_true(law_dot(mesh->patch[p].normal, law_add(mesh->patch[p].point, -1.0, mesh->centre)) > 0.4);
    wall_mesh_destroy(&mesh);
    struct wall_options rectangle = {
        .shape = WALL_RECTANGLE, .point = {1, 1, 1}, .along = {0, 2, 0}, .across = {0, 0, 3}};
    mesh = shape_surface(&rectangle, &area);
    assert_near(area, 6.0, 1e-14);
    assert_int_equal(mesh->patches, 1);
    assert_int_equal(wall_mesh_open_edges(mesh, true), 4);
    assert_near(shape_distance(mesh, 1, 4, 2), 1.0, 1e-14);
    wall_mesh_destroy(&mesh);
    for (int n = 6; n <= 600; n *= 10) {
        double sine = sin(M_PI / n), polygon = 0.5 * n * sin(2.0 * M_PI / n), far = 1.0 - cos(M_PI / n);
        struct wall_options disc = {.shape = WALL_DISC,
                                    .point = {1, 2, 3},
                                    .normal = {1, 2, -2},
                                    .radius = 2,
                                    .hole = 0.5,
                                    .segments = n};
        mesh = shape_surface(&disc, &area);
        assert_near(area, polygon * (4 - 0.25), 1e-12);
        assert_int_equal(mesh->patches, 1);
        assert_near(shape_distance(mesh, 1, 2, 3), 0.5, 0.5 * far + 1e-12);
        wall_mesh_destroy(&mesh);
        struct wall_options cone = {
            .shape = WALL_CONE, .axis = {0, 0, 2}, .radius = 1, .radius_end = 4, .length = 4, .segments = n};
        mesh = shape_surface(&cone, &area);
        double slant = hypot(4.0, 3.0 * cos(M_PI / n)); /* height of a side's trapezoid */
        assert_near(area, n * sine * (1 + 4) * slant, 1e-11);
        assert_int_equal(mesh->patches, n);
        /* from the axis half way up: the radius there times the cosine of half the angle of the cone */
        assert_near(shape_distance(mesh, 0, 0, 2), 2.5 * 0.8, 4 * far + 1e-12);
        wall_mesh_destroy(&mesh);
        cone.radius_end = 0;
        mesh = shape_surface(&cone, &area);
        assert_near(area, n * sine * hypot(4.0, cos(M_PI / n)), 1e-12);
        wall_mesh_destroy(&mesh);
    }
    struct wall_options flat = {.shape = WALL_RECTANGLE, .along = {1, 0, 0}, .across = {2, 0, 0}};
    struct mesh none;
    struct error error = {0};
    assert_false(mesh_shape_make(&none, &flat, &error));
    assert_int_equal(error.kind, ERROR_USER);
}

/* Patches are of one plane, connected: not two coplanar plates, nor a ring of narrow facets. */
static void test_patches(void **state) {
    (void)state;
    struct hand_text t = text_new();
    double o[3] = {0, 0, 0}, a[3] = {1, 0, 0}, b[3] = {0, 1, 0}, apart[3] = {2, 0, 0};
    text_plate(&t, o, a, b, 3, 3, 0.5);
    text_plate(&t, apart, a, b, 3, 3, 0.5);
    struct wall_mesh *mesh = text_surface(&t);
    assert_int_equal(mesh->patches, 2);
    assert_int_equal(mesh->edges, 24);
    wall_mesh_destroy(&mesh);
    enum { FACETS = 2000 };
    t = text_new();
    for (int k = 0; k < FACETS; k++) {
        double angle = 2.0 * M_PI * k / FACETS, next = 2.0 * M_PI * (k + 1) / FACETS;
        double from[3] = {cos(angle), sin(angle), 0},
               along[3] = {cos(next) - cos(angle), sin(next) - sin(angle), 0}, up[3] = {0, 0, 0.5};
        text_plate(&t, from, along, up, 1, 1, 0.0);
    }
    mesh = text_surface(&t);
    assert_int_equal(mesh->patches, FACETS);
    assert_int_equal(mesh->edges, 3 * FACETS);
    wall_mesh_destroy(&mesh);
}

/* A rib on a plate: the plate goes on below it. */
static void test_three_at_an_edge(void **state) {
    (void)state;
    static const char rows[] = "0 0 0 1 0 0 0 1 0\n0 0 0 1 0 0 0 -1 0\n0 0 0 1 0 0 0 0 1\n";
    struct wall_mesh *mesh = surface(rows, sizeof rows - 1, NULL);
    assert_int_equal(mesh->patches, 2);
    int without = 0;
    for (int t = 0; t < 3; t++)
        for (int k = 0; k < 3; k++)
            without += mesh->triangle[t].edge[k] < 0;
    assert_int_equal(without, 2);     /* the common edge, seen from both halves of the plate */
    assert_int_equal(mesh->edges, 7); /* and the rib has it */
    wall_mesh_destroy(&mesh);
}

static void test_repairs(void **state) {
    (void)state;
    static const char rows[] = "0 0 0 1 0 0 0 1 0\n"
                               "1 0 3e-7 1 1 0 0 1 0\n"   /* a corner nearly met */
                               "0 0 0 0.5 0 1e-9 1 0 0\n" /* no height */
                               "0 0 0 0 0 1e-8 1 1 0\n"   /* two corners in one place */
                               "0 1 0 0 0 0 1 0 0\n";     /* the first again */
    char notes[2048];
    struct wall_mesh *mesh = surface(rows, sizeof rows - 1, notes);
    assert_int_equal(mesh->triangles, 2);
    assert_int_equal(mesh->patches, 1);
    assert_int_equal(mesh->edges, 4);
    assert_non_null(strstr(notes, "M: 2 corners moved by up to 3e-07 onto"));
    assert_non_null(strstr(notes, "M:3: triangle 3 is too thin"));
    assert_non_null(strstr(notes, "M:4: triangle 4 is too thin"));
    assert_non_null(strstr(notes, "M:5: triangle 5 has the corners of an earlier one"));
    wall_mesh_destroy(&mesh);
}

static void refuse(const char *rows, const struct wall_mesh_place *place, const char *words) {
    char path[64];
    struct mesh file;
    struct wall_mesh *mesh;
    struct error error = {0};
    hand_file(path, "refuse", rows, strlen(rows));
    must(mesh_read(&file, path, "table", &error), &error);
    remove(path);
    assert_false(wall_mesh_create(&mesh, &file, "M", place, NULL, &error));
    assert_null(mesh);
    assert_int_equal(error.kind, ERROR_USER);
    if (strstr(error.text, words) == NULL)
        fail_msg("'%s' lacks '%s'", error.text, words);
    mesh_free(&file);
}

static void test_refused(void **state) {
    (void)state;
    struct wall_mesh_place away = {.scale = 1.0, .shift = {1e12, 0, 0}}, huge = {.scale = 1e300};
    refuse("0 0 0 1 1 1 2 2 2\n", &as_it_is, "no triangle is left: all 1 are degenerate");
    refuse("1 1 1 1 1 1 1 1 1\n", &as_it_is, "all corners lie at one point");
    refuse("0 0 0 1 0 0 0 1 0\n", &away, "check scale and offset");
    refuse("0 0 0 1e200 0 0 0 1 0\n", &huge, "check scale and offset");
}

/* The grid finds what brute force finds, each once. */
static void test_grid(void **state) {
    (void)state;
    struct hand_text t = text_new();
    double o[3] = {5, 5, 5}, a[3] = {3, 1, 0}, b[3] = {0, 0, 9};
    text_cube(&t, 0.0, 4.0, 7);
    text_plate(&t, o, a, b, 1, 40, 0.5);
    struct wall_mesh *mesh = text_surface(&t);
    struct wall_grid *grid = wall_grid_create(mesh);
    int32_t *found = memory_allocate(mesh->triangles, sizeof *found, "test");
    uint8_t *seen = memory_allocate(mesh->triangles, 1, "test");
    unsigned seed = 11;
    size_t total = 0;
    for (int k = 0; k < 2000; k++) {
        struct law_vector x = {12.0 * hand_random(&seed) - 2.0, 12.0 * hand_random(&seed) - 2.0,
                               20.0 * hand_random(&seed) - 2.0};
        double reach = pow(10.0, 2.0 * hand_random(&seed) - 1.5);
        size_t n = wall_grid_query(grid, x, reach, found), expected = 0;
        assert_int_equal(wall_grid_query(grid, x, reach, NULL), n);
        memset(seen, 0, mesh->triangles);
        for (size_t f = 0; f < n; f++)
            assert_false(seen[found[f]]++);
        for (size_t i = 0; i < mesh->triangles; i++) {
            bool near = wall_touch_nearest(mesh, (int32_t)i, x, INFINITY).distance < reach;
            expected += near;
            assert_int_equal(near, seen[i]);
        }
        assert_int_equal(n, expected);
        total += n;
    }
    assert_true(total > 3000);
    memory_free(found);
    memory_free(seen);
    wall_grid_destroy(&grid);
    wall_mesh_destroy(&mesh);
}

/* The meshes of the shipped examples. */
static void test_examples(void **state) {
    (void)state;
    const char *folder = getenv("top_srcdir");
    const struct {
        const char *name;
        size_t triangles, patches, edges;
    } example[] = {{"penetration", 56, 11, 32}, {"drum", 1200, 205, 805}};
    for (int k = 0; k < 2; k++) {
        char path[1024], notes[2048] = "";
        struct mesh file;
        struct wall_mesh *mesh;
        struct error error = {0};
        snprintf(path, sizeof path, "%s/examples/%s/walls.txt", folder ? folder : ".", example[k].name);
        must(mesh_read(&file, path, "", &error), &error);
        FILE *stream = fmemopen(notes, sizeof notes, "w");
        must(wall_mesh_create(&mesh, &file, path, &as_it_is, stream, &error), &error);
        fclose(stream);
        assert_string_equal(notes, "");
        assert_int_equal(mesh->triangles, example[k].triangles);
        assert_int_equal(mesh->patches, example[k].patches);
        assert_int_equal(mesh->edges, example[k].edges);
        wall_mesh_destroy(&mesh);
        mesh_free(&file);
    }
}

TEST_MAIN(wall_mesh, cmocka_unit_test(test_cube), cmocka_unit_test(test_patches),
          cmocka_unit_test(test_three_at_an_edge), cmocka_unit_test(test_repairs),
          cmocka_unit_test(test_refused), cmocka_unit_test(test_grid), cmocka_unit_test(test_shapes),
          cmocka_unit_test(test_examples))
