/* SPDX-License-Identifier: BSD-3-Clause */
/* Where a sphere touches a mesh or a cylinder, against exact distances. */
#include "tests/test.h"

#include "physics/grains/walls/wall_grid.h"
#include "physics/grains/walls/wall_mesh.h"
#include "physics/grains/walls/wall_touch.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/surface_by_hand.h"

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

/* Contacts with images of a tube end to end: the shell before the rim, equal points once; rims apart stay. */
static void test_cylinder_images(void **state) {
    (void)state;
    struct wall_cylinder tube = {.axis = {0, 0, 1}, .radius = 2.0, .length = 4.0, .inside = true};
    const double apart[4] = {4.0, 3.9, 4.0002, 4.3};
    const size_t left[4] = {1, 1, 1, 2};
    for (int k = 0; k < 4; k++) {
        struct wall_touch touch[2];
        double height = 0.5 * apart[k]; /* over the middle of the seam */
        assert_true(wall_cylinder_touch(&tube, (struct law_vector){1.6, 0, height}, 0.5, &touch[0]));
        assert_true(
            wall_cylinder_touch(&tube, (struct law_vector){1.6, 0, height - apart[k]}, 0.5, &touch[1]));
        touch[0].image = 1;
        touch[1].image = 0;
        assert_int_equal(wall_cylinder_resolve(&tube, touch, 2, 0.5), left[k]);
        assert_near(touch->normal.x, apart[k] > 4.1 ? 0.4 / hypot(0.4, 0.15) : 1.0, 1e-6);
        assert_int_equal(touch->image, k == 2 || k == 3 ? 1 : 0);
    }
    struct wall_touch touch[2]; /* a little beside the seam: the rim comes first here, the shell there */
    assert_true(wall_cylinder_touch(&tube, (struct law_vector){1.6, 0, 2.1}, 0.5, &touch[0]));
    assert_true(wall_cylinder_touch(&tube, (struct law_vector){1.6, 0, -1.9}, 0.5, &touch[1]));
    assert_int_equal(touch[0].feature, WALL_CYLINDER_UPPER);
    assert_int_equal(wall_cylinder_resolve(&tube, touch, 2, 0.5), 1);
    assert_int_equal(touch->feature, WALL_CYLINDER_SHELL);
}

TEST_MAIN(wall_touch, cmocka_unit_test(test_nearest), cmocka_unit_test(test_convex),
          cmocka_unit_test(test_concave), cmocka_unit_test(test_hidden), cmocka_unit_test(test_notch),
          cmocka_unit_test(test_cylinder), cmocka_unit_test(test_cylinder_images))
