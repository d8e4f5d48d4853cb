/* Surfaces of meshes: vertices merged, patches and features found, repairs noted, triangles found by the
 * grid, contacts against exact distances. */
#include "contact/wall_grid.h"
#include "contact/wall_mesh.h"
#include "contact/wall_touch.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include "near.h"
#include "mesh_by_hand.h"

static const struct wall_mesh_place as_it_is = {.scale = 1.0};

/* Makes the surface of a text; notes go to `notes` (2048 bytes) if that is not NULL. */
static struct wall_mesh *surface(const char *text, size_t size, char *notes) {
    char path[64];
    struct mesh file;
    struct wall_mesh *mesh;
    struct error error = {0};
    hand_file(path, "surface", text, size);
    must(mesh_read(&file, path, "table", &error), &error);
    remove(path);
    FILE *stream = notes ? fmemopen(notes, 2048, "w") : NULL;
    must(wall_mesh_create(&mesh, &file, "M", &as_it_is, stream, &error), &error);
    if (stream)
        fclose(stream);
    mesh_free(&file);
    return mesh;
}

static struct wall_mesh *text_surface(struct hand_text *t) {
    struct wall_mesh *mesh = surface(t->text, t->size, NULL);
    memory_free(t->text);
    return mesh;
}

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
        assert_true(wall_mesh_memory(mesh) > 12 * sizeof(struct wall_triangle));
        wall_mesh_destroy(&mesh);
        assert_null(mesh);
    }
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

/* Distance of x to a triangle by its definition, minimised over the barycentric coordinates: an oracle that
 * shares nothing with the code. */
static double distance_by_hand(const struct wall_triangle *t, struct law_vector x) {
    double best = INFINITY;
    struct law_vector ab = law_add(t->corner[1], -1.0, t->corner[0]),
                      ac = law_add(t->corner[2], -1.0, t->corner[0]);
    double u = 1.0 / 3.0, v = u;
    for (double step = 0.5; step > 1e-9; step *= 0.7)
        for (int k = 0; k < 12; k++) {
            double angle = 2.0 * M_PI * k / 12.0, tu = u + step * cos(angle), tv = v + step * sin(angle);
            tu = tu < 0.0 ? 0.0 : tu > 1.0 ? 1.0 : tu;
            tv = tv < 0.0 ? 0.0 : tv > 1.0 - tu ? 1.0 - tu : tv;
            struct law_vector d = law_add(law_add(law_add(t->corner[0], tu, ab), tv, ac), -1.0, x);
            double far = sqrt(law_dot(d, d));
            if (far < best) {
                best = far;
                u = tu;
                v = tv;
            }
        }
    return best;
}

static void test_nearest(void **state) {
    (void)state;
    static const char rows[] = "0 0 0 1 0.2 0.1 0.3 0.9 -0.2\n";
    struct wall_mesh *mesh = surface(rows, sizeof rows - 1, NULL);
    unsigned seed = 3;
    int kinds[3] = {0};
    for (int k = 0; k < 3000; k++) {
        struct law_vector x = {2.0 * hand_random(&seed) - 0.5, 2.0 * hand_random(&seed) - 0.5,
                               2.0 * hand_random(&seed) - 1.0};
        struct wall_nearest near = wall_touch_nearest(mesh, 0, x, INFINITY);
        assert_near(near.distance, distance_by_hand(&mesh->triangle[0], x), 1e-4);
        assert_near(sqrt(law_dot(near.to, near.to)), near.distance, 1e-14);
        double reach = 0.1 + hand_random(&seed);
        struct wall_nearest bounded = wall_touch_nearest(mesh, 0, x, reach);
        assert_true(near.distance < reach ? bounded.distance == near.distance && bounded.kind == near.kind
                                          : bounded.distance >= reach);
        kinds[near.kind]++;
    }
    assert_true(kinds[0] > 100 && kinds[1] > 100 && kinds[2] > 100);
    wall_mesh_destroy(&mesh);
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
    assert_true(wall_grid_memory(grid) > mesh->triangles * sizeof(int32_t));
    memory_free(found);
    memory_free(seen);
    wall_grid_destroy(&grid);
    wall_mesh_destroy(&mesh);
}

/* All contacts of a sphere with a mesh, from all of its triangles. */
static size_t touches(const struct wall_mesh *mesh, struct law_vector x, double radius,
                      struct wall_touch *touch) {
    struct wall_nearest *near = memory_allocate(mesh->triangles, sizeof *near, "test");
    size_t count = 0;
    for (size_t t = 0; t < mesh->triangles; t++) {
        near[count] = wall_touch_nearest(mesh, (int32_t)t, x, INFINITY);
        count += near[count].distance < radius;
    }
    count = wall_touch_resolve(mesh, near, count, radius, touch);
    memory_free(near);
    return count;
}

/* Outside of a cube there is one contact, at the nearest point, on faces, edges and at corners. */
static void test_convex(void **state) {
    (void)state;
    for (int n = 1; n <= 4; n += 3) {
        struct hand_text t = text_new();
        text_cube(&t, -1.0, 1.0, n);
        struct wall_mesh *mesh = text_surface(&t);
        struct wall_touch *touch = memory_allocate(mesh->triangles, sizeof *touch, "test");
        unsigned seed = 5;
        int by_sides[4] = {0};
        for (int k = 0; k < 4000; k++) {
            double x[3], to[3], square = 0.0;
            int sides = 0;
            for (int d = 0; d < 3; d++) {
                x[d] = 3.2 * hand_random(&seed) - 1.6;
                if (k % 5 == 0 && d < 2)
                    x[d] = x[d] < 0.0 ? -1.0 : 1.0; /* right over an edge */
                double at = x[d] < -1.0 ? -1.0 : x[d] > 1.0 ? 1.0 : x[d];
                to[d] = at - x[d];
                sides += to[d] != 0.0;
                square += to[d] * to[d];
            }
            if (sides == 0)
                continue;
            double radius = 0.55, distance = sqrt(square);
            size_t count = touches(mesh, wall_vector(x), radius, touch);
            assert_int_equal(count, distance < radius ? 1 : 0);
            if (count == 0)
                continue;
            by_sides[sides]++;
            assert_near(touch->distance, distance, 1e-14);
            assert_near(law_dot(touch->normal, wall_vector(to)), distance, 1e-14);
            double again;
            struct law_vector toward = wall_touch_toward(mesh, touch->feature, wall_vector(x), &again);
            assert_near(again, distance, 1e-14);
            assert_near(law_dot(toward, touch->normal), 1.0, 1e-14);
        }
        assert_true(by_sides[1] > 300 && by_sides[2] > 300 && by_sides[3] > 50);
        memory_free(touch);
        wall_mesh_destroy(&mesh);
    }
}

/* Inside of a cube each side that is near counts, and nothing else. */
static void test_concave(void **state) {
    (void)state;
    struct hand_text t = text_new();
    text_cube(&t, -1.0, 1.0, 3);
    struct wall_mesh *mesh = text_surface(&t);
    struct wall_touch *touch = memory_allocate(mesh->triangles, sizeof *touch, "test");
    unsigned seed = 9;
    int seen[4] = {0};
    for (int k = 0; k < 4000; k++) {
        double x[3], radius = 0.4;
        size_t expected = 0;
        for (int d = 0; d < 3; d++) {
            x[d] = 1.98 * hand_random(&seed) - 0.99;
            expected += 1.0 - fabs(x[d]) < radius;
        }
        size_t count = touches(mesh, wall_vector(x), radius, touch);
        assert_int_equal(count, expected);
        seen[count]++;
        for (size_t c = 0; c < count; c++) {
            assert_int_equal(touch[c].kind, WALL_TOUCH_FACE);
            const double n[3] = {touch[c].normal.x, touch[c].normal.y, touch[c].normal.z};
            int d = fabs(n[0]) > 0.5 ? 0 : fabs(n[1]) > 0.5 ? 1 : 2;
            assert_near(touch[c].distance, 1.0 - fabs(x[d]), 1e-14);
            assert_near(n[d], x[d] < 0.0 ? -1.0 : 1.0, 1e-14);
        }
    }
    assert_true(seen[1] > 300 && seen[2] > 300 && seen[3] > 100);
    memory_free(touch);
    wall_mesh_destroy(&mesh);
}

/* The far side of a thin plate, a seam without common vertices, and two plates that overlap in one plane
 * count once. */
static void test_hidden(void **state) {
    (void)state;
    struct hand_text t = text_new();
    double a[3] = {1, 0, 0}, b[3] = {0, 1, 0}, half[3] = {0, 0.5, 0},
           o[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}};
    double below[3] = {-1, -1, -0.02}, wide[3] = {4, 0, 0}, deep[3] = {0, 3, 0}, over[3] = {0.25, 0.25, 0};
    text_plate(&t, o[0], a, b, 1, 1, 0.0);
    text_plate(&t, o[1], a, half, 1, 1, 0.0);
    text_plate(&t, o[2], a, half, 1, 1, 0.0);
    text_plate(&t, over, a, half, 1, 1, 0.0);
    text_plate(&t, below, wide, deep, 1, 1, 0.0);
    struct wall_mesh *mesh = text_surface(&t);
    struct wall_touch *touch = memory_allocate(mesh->triangles, sizeof *touch, "test");
    for (double x = 0.05; x < 1.96; x += 0.05)
        for (double y = 0.05; y < 0.96; y += 0.05) {
            assert_int_equal(touches(mesh, (struct law_vector){x, y, 0.15}, 0.2, touch), 1);
            assert_near(touch->distance, 0.15, 1e-14);
            assert_near(touch->normal.z, -1.0, 1e-14);
            assert_int_equal(touches(mesh, (struct law_vector){x, y, -0.15}, 0.2, touch), 1);
            assert_near(touch->distance, 0.13, 1e-14);
            assert_near(touch->normal.z, 1.0, 1e-14);
        }
    memory_free(touch);
    wall_mesh_destroy(&mesh);
}

/* A notch in one flat plate: a sphere over it touches its two edges, which belong to one patch. */
static void test_notch(void **state) {
    (void)state;
    struct hand_text t = text_new();
    double o[3][3] = {{0, 0, 0}, {0, 1, 0}, {2, 1, 0}}, one[3] = {1, 0, 0}, up[3] = {0, 1, 0};
    double corner[3] = {1, 0, 0}, far[3] = {2, 0, 0};
    text_plate(&t, o[1], one, up, 1, 1, 0.0);
    text_plate(&t, o[2], one, up, 1, 1, 0.0);
    text_plate(&t, o[0], one, up, 1, 1, 0.0);
    text_plate(&t, corner, one, up, 1, 1, 0.0);
    text_plate(&t, far, one, up, 1, 1, 0.0);
    struct wall_mesh *mesh = text_surface(&t);
    struct wall_touch touch[16];
    assert_int_equal(mesh->patches, 1);
    assert_int_equal(touches(mesh, (struct law_vector){1.5, 1.8, 0.3}, 0.6, touch), 2);
    assert_near(touch[0].normal.z, -0.3 / sqrt(0.34), 1e-14);
    assert_near(touch[0].normal.x + touch[1].normal.x, 0.0, 1e-14);
    assert_int_equal(touches(mesh, (struct law_vector){1.5, 0.95, 0.3}, 0.6, touch), 1); /* on the face */
    assert_int_equal(touches(mesh, (struct law_vector){1.5, 1.05, 0.3}, 0.6, touch), 3); /* three edges */
    wall_mesh_destroy(&mesh);
}

static void test_cylinder(void **state) {
    (void)state;
    struct wall_cylinder tube = {.axis = {0, 0, 1}, .radius = 2.0, .inside = true};
    struct wall_touch touch;
    assert_true(wall_cylinder_touch(&tube, (struct law_vector){1.6, 0, 9}, 0.5, &touch));
    assert_near(touch.distance, 0.4, 1e-15);
    assert_near(touch.normal.x, 1.0, 1e-15);
    assert_false(wall_cylinder_touch(&tube, (struct law_vector){1.4, 0, 9}, 0.5, &touch));
    assert_true(wall_cylinder_touch(&tube, (struct law_vector){0, -5, 9}, 0.5, &touch));
    assert_near(touch.distance, -3.0, 1e-15); /* deep in the solid */
    assert_near(touch.normal.y, -1.0, 1e-15);
    assert_true(wall_cylinder_near(&tube, (struct law_vector){1.2, 0, 0}, 0.9));
    assert_false(wall_cylinder_near(&tube, (struct law_vector){1.0, 0, 0}, 0.9));
    tube.inside = false;
    assert_true(wall_cylinder_touch(&tube, (struct law_vector){2.4, 0, 9}, 0.5, &touch));
    assert_near(touch.distance, 0.4, 1e-15);
    assert_near(touch.normal.x, -1.0, 1e-15);
    assert_true(wall_cylinder_touch(&tube, (struct law_vector){0, 0, 9}, 0.5, &touch));
    assert_near(touch.distance, -2.0, 0.0); /* on the axis: some direction across it */
    assert_near(law_dot(touch.normal, touch.normal), 1.0, 1e-15);
    assert_near(touch.normal.z, 0.0, 0.0);
    tube.length = 4.0;
    assert_false(wall_cylinder_touch(&tube, (struct law_vector){0, 0, 1}, 0.5, &touch));
    assert_true(wall_cylinder_touch(&tube, (struct law_vector){2.3, 0, 2.0}, 0.5, &touch));
    assert_int_equal(touch.feature, WALL_CYLINDER_SHELL);
    assert_true(wall_cylinder_touch(&tube, (struct law_vector){2.3, 0, 2.4}, 0.6, &touch));
    assert_int_equal(touch.feature, WALL_CYLINDER_UPPER);
    assert_near(touch.distance, 0.5, 1e-15);
    assert_near(touch.normal.x, -0.6, 1e-15);
    assert_near(touch.normal.z, -0.8, 1e-15);
    assert_true(wall_cylinder_touch(&tube, (struct law_vector){0, 1.7, -2.4}, 0.6, &touch));
    assert_int_equal(touch.feature, WALL_CYLINDER_LOWER);
    assert_near(touch.normal.z, 0.8, 1e-15);
    assert_false(wall_cylinder_touch(&tube, (struct law_vector){2.3, 0, 2.6}, 0.6, &touch));
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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_cube),
                                       cmocka_unit_test(test_patches),
                                       cmocka_unit_test(test_three_at_an_edge),
                                       cmocka_unit_test(test_repairs),
                                       cmocka_unit_test(test_refused),
                                       cmocka_unit_test(test_nearest),
                                       cmocka_unit_test(test_grid),
                                       cmocka_unit_test(test_convex),
                                       cmocka_unit_test(test_concave),
                                       cmocka_unit_test(test_hidden),
                                       cmocka_unit_test(test_notch),
                                       cmocka_unit_test(test_cylinder),
                                       cmocka_unit_test(test_examples)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
