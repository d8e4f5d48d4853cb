/* SPDX-License-Identifier: BSD-3-Clause */
/* Distance fields of meshes: a sphere of 20,000 triangles and a cube against closed forms, the order of the error, gradients
 * without jumps, contacts beside those of triangles. */
#include "tests/test.h"

#include "physics/grains/walls/wall_field.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/mesh_by_hand.h"

enum { AROUND = 100, UP = 101, PLACES = 4000 };

static struct wall_mesh *mesh_of(const struct mesh *file) {
    struct wall_mesh_place place = {.scale = 1.0};
    struct wall_mesh *mesh;
    struct error error = {0};
    must(wall_mesh_create(&mesh, file, "test", &place, NULL, &error), &error);
    return mesh;
}

static void ball_point(double out[3], int up, int around, double radius) {
    double height = M_PI * up / UP, angle = 2.0 * M_PI * around / AROUND;
    out[0] = radius * sin(height) * cos(angle);
    out[1] = radius * sin(height) * sin(angle);
    out[2] = radius * cos(height);
}

/* A ball about the origin, of AROUND x UP parts; the normals point outwards. */
static struct mesh ball(double radius) {
    struct mesh mesh = {.corner = memory_allocate(2 * AROUND * UP, sizeof *mesh.corner, "ball")};
    for (int u = 0; u < UP; u++)
        for (int a = 0; a < AROUND; a++) {
            double corner[4][3];
            ball_point(corner[0], u, a, radius);
            ball_point(corner[1], u + 1, a, radius);
            ball_point(corner[2], u + 1, (a + 1) % AROUND, radius);
            ball_point(corner[3], u, (a + 1) % AROUND, radius);
            for (int t = 0; t < 2; t++) {
                if (t == 0 ? u + 1 == UP : u == 0)
                    continue;
                double *out = mesh.corner[mesh.count++];
                memcpy(out, corner[0], sizeof corner[0]);
                memcpy(out + 3, corner[1 + t], sizeof corner[0]);
                memcpy(out + 6, corner[2 + t], sizeof corner[0]);
            }
        }
    return mesh;
}

/* The cube from -1 to 1. */
static struct mesh cube(void) {
    struct mesh mesh = {.corner = memory_allocate(12, sizeof *mesh.corner, "cube")};
    for (int side = 0; side < 6; side++) {
        int d = side / 2, e = (d + 1) % 3, f = (d + 2) % 3;
        double out = side % 2 ? 1.0 : -1.0, corner[4][3];
        for (int k = 0; k < 4; k++) {
            corner[k][d] = out;
            corner[k][e] = (k == 1 || k == 2) ? out : -out;
            corner[k][f] = k >= 2 ? 1.0 : -1.0;
        }
        for (int t = 0; t < 2; t++) {
            double *to = mesh.corner[mesh.count++];
            memcpy(to, corner[0], sizeof corner[0]);
            memcpy(to + 3, corner[1 + t], sizeof corner[0]);
            memcpy(to + 6, corner[2 + t], sizeof corner[0]);
        }
    }
    return mesh;
}

static double cube_distance(const double x[3]) {
    double square = 0.0, inside = -INFINITY;
    for (int d = 0; d < 3; d++) {
        double out = fabs(x[d]) - 1.0;
        square += out > 0.0 ? out * out : 0.0;
        inside = fmax(inside, out);
    }
    return inside > 0.0 ? sqrt(square) : inside;
}

static struct wall_field *field_of(const struct wall_mesh *mesh, double spacing, double reach) {
    struct wall_field *field;
    struct error error = {0};
    must(wall_field_create(&field, mesh, spacing, "test", &error), &error);
    wall_field_cover(field, reach);
    return field;
}

static struct law_vector vector(const double x[3]) {
    return (struct law_vector){x[0], x[1], x[2]};
}

/* The largest error of the distance, and of the direction (an angle), on both sides of a ball of radius 1. */
static void ball_errors(const struct wall_field *field, double within, double error[2]) {
    unsigned seed = 7;
    error[0] = error[1] = 0.0;
    for (int k = 0; k < PLACES; k++) {
        double x[3], distance;
        struct law_vector gradient;
        for (int d = 0; d < 3; d++)
            x[d] = 3.0 * hand_random(&seed) - 1.5;
        double radius = hand_length(x);
        if (fabs(radius - 1.0) > within)
            continue;
        assert_true(wall_field_at(field, vector(x), &distance, &gradient));
        error[0] = fmax(error[0], fabs(distance - (radius - 1.0)));
        struct law_vector across = law_cross(gradient, law_scale(1.0 / radius, vector(x)));
        error[1] = fmax(error[1], sqrt(law_dot(across, across) / law_dot(gradient, gradient)));
    }
}

/* The error of a ball falls at third order or faster, down to that of the triangles themselves, 6e-4. */
static void test_ball(void **state) {
    (void)state;
    static const double spacing[3] = {0.5, 0.25, 0.0625};
    struct mesh file = ball(1.0);
    struct wall_mesh *mesh = mesh_of(&file);
    double error[3][2];
    assert_true(mesh->triangles > 19900 && wall_mesh_open_edges(mesh, true) == 0);
    for (int k = 0; k < 3; k++) {
        struct wall_field *field = field_of(mesh, spacing[k], 0.5);
        ball_errors(field, 0.4, error[k]);
        struct wall_field_figures figures = wall_field_look(field);
        print_message("spacing %g: error %.3g, of the direction %.3g; found by itself %.3g, %zu tiles\n",
                      spacing[k], error[k][0], error[k][1], figures.error, figures.tiles);
        assert_true(figures.tiles > 0 && figures.bytes > 8 * 1331 * figures.tiles);
        wall_field_destroy(&field);
    }
    assert_true(error[0][0] > 5.0 * error[1][0]);
    assert_true(error[2][0] < 7e-4 && error[2][1] < 0.02);
    mesh_free(&file);
    wall_mesh_destroy(&mesh);
}

/* A cube: exact beside faces, of second order around edges and corners from two spacings on, and the error that the field
 * finds by itself is not smaller than half of what a search finds. */
static void test_cube(void **state) {
    (void)state;
    struct mesh file = cube();
    struct wall_mesh *mesh = mesh_of(&file);
    double found[2];
    for (int k = 0; k < 2; k++) {
        double spacing = k ? 0.05 : 0.1, most = 0.0, any = 0.0;
        struct wall_field *field = field_of(mesh, spacing, 0.45);
        unsigned seed = 3;
        for (int n = 0; n < PLACES; n++) {
            double x[3], distance;
            struct law_vector gradient;
            for (int d = 0; d < 3; d++)
                x[d] = 3.0 * hand_random(&seed) - 1.5;
            double exact = cube_distance(x), low = fmin(fmin(fabs(x[0]), fabs(x[1])), fabs(x[2])),
                   high = fmax(fmax(fabs(x[0]), fabs(x[1])), fabs(x[2])),
                   middle = fabs(x[0]) + fabs(x[1]) + fabs(x[2]) - low - high;
            if (fabs(exact) > 0.4)
                continue;
            assert_true(wall_field_at(field, vector(x), &distance, &gradient));
            any = fmax(any, fabs(distance - exact));
            if (exact > 2.5 * 0.1)
                most = fmax(most, fabs(distance - exact));
            if (fmin(high, 1.0) - middle > 3.0 * spacing)
                assert_near(distance, exact, 1e-12);
        }
        struct wall_field_figures figures = wall_field_look(field);
        print_message("spacing %g: error %.3g beyond edges, %.3g at any place; found by itself %.3g\n",
                      spacing, most, any, figures.error);
        assert_true(any < 0.2 * spacing && figures.error > 0.5 * any && figures.error < 0.2 * spacing);
        found[k] = most;
        wall_field_destroy(&field);
    }
    assert_true(found[0] > 3.0 * found[1] && found[0] < 0.005);
    mesh_free(&file);
    wall_mesh_destroy(&mesh);
}

/* The gradient is the slope of the distance, and has no jump where cells and tiles meet; values do not depend on the reach. */
static void test_smooth(void **state) {
    (void)state;
    struct mesh file = cube();
    struct wall_mesh *mesh = mesh_of(&file);
    struct wall_field *field = field_of(mesh, 0.1, 0.45), *near = field_of(mesh, 0.1, 0.2);
    unsigned seed = 5;
    for (int n = 0; n < 400; n++) {
        double x[3], distance[4];
        struct law_vector gradient[4], step = {1e-6, 0.0, 0.0};
        for (int d = 0; d < 3; d++)
            x[d] = 2.6 * hand_random(&seed) - 1.3;
        if (fabs(cube_distance(x)) > 0.18)
            continue;
        struct law_vector at = vector(x);
        assert_true(wall_field_at(field, law_add(at, 1.0, step), &distance[1], &gradient[1]));
        assert_true(wall_field_at(field, law_add(at, -1.0, step), &distance[2], &gradient[2]));
        assert_true(wall_field_at(field, at, &distance[0], &gradient[0]));
        assert_near((distance[1] - distance[2]) / 2e-6, gradient[0].x, 1e-5);
        assert_true(wall_field_at(near, at, &distance[3], &gradient[3]));
        assert_true(distance[3] == distance[0] && gradient[3].y == gradient[0].y);
        at.y =
            -1.0 + 0.1 * floor(20.0 * hand_random(&seed)); /* a face between cells, at times between tiles */
        const double place[3] = {at.x, at.y, at.z};
        if (fabs(cube_distance(place)) > 0.18)
            continue;
        at.y -= 1e-9;
        wall_field_at(field, at, &distance[1], &gradient[1]);
        at.y += 2e-9;
        wall_field_at(field, at, &distance[2], &gradient[2]);
        assert_near(distance[1], distance[2], 1e-8);
        assert_near(gradient[1].y, gradient[2].y, 1e-6);
        assert_near(gradient[1].z, gradient[2].z, 1e-6);
    }
    wall_field_cover(near, 0.45);
    struct law_vector gradient;
    double distance;
    assert_true(wall_field_at(near, (struct law_vector){0.0, 0.0, 1.4}, &distance, &gradient));
    assert_near(distance, 0.4, 1e-12);
    assert_false(wall_field_at(near, (struct law_vector){0.0, 0.0, 9.0}, &distance, &gradient));
    wall_field_destroy(&near);
    wall_field_destroy(&field);
    mesh_free(&file);
    wall_mesh_destroy(&mesh);
}

/* Writes a mesh as binary STL. */
static const char *stl(char path[64], const char *name, const struct mesh *mesh) {
    size_t size = 84 + 50 * mesh->count;
    char *text = memory_allocate_zero(size, 1, "test mesh");
    uint32_t count = (uint32_t)mesh->count;
    memcpy(text + 80, &count, sizeof count);
    for (size_t t = 0; t < mesh->count; t++)
        for (int c = 0; c < 9; c++) {
            float number = (float)mesh->corner[t][c];
            memcpy(text + 84 + 50 * t + 12 + 4 * c, &number, sizeof number);
        }
    hand_file(path, name, text, size);
    memory_free(text);
    return path;
}

/* Spheres that bounce in a ball without loss: energy and angular momentum about the middle, which facets would change; the
 * world with a field beside that with triangles. */
static void test_bowl(void **state) {
    (void)state;
    char path[64];
    struct mesh file = ball(1.0);
    double before[2] = {0}, energy[2] = {0}, spin[2] = {0};
    stl(path, "ball.stl", &file);
    for (int k = 0; k < 2; k++) {
        struct wall_options wall = hand_mesh(path);
        struct world w;
        wall.field = k == 1;
        wall.field_spacing = 0.04;
        for (int d = 0; d < 3; d++)
            wall.offset[d] = 2.0;
        world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 2);
        for (int i = 0; i < 8; i++) {
            struct particle_state *s = world_add(&w, 1.6 + 0.1 * i, 2.1, 1.9 + 0.02 * i, 0.1, 0.1);
            s->v[0] = 1.0 - 0.3 * i;
            s->v[2] = 1.5;
        }
        world_build(&w);
        for (int n = 0; n < 20000; n++) {
            world_step(&w, n % 25 == 0, NULL);
            if (n > 0 && n < 19999)
                continue;
            double sum = 0.0, moment = 0.0;
            for (int i = 0; i < 8; i++) {
                const struct particle_state *s = &w.particles->state[i];
                sum += 0.05 * law_dot(vector(s->v), vector(s->v));
                moment += 0.1 * ((s->x[2] - 2.0) * s->v[0] - (s->x[0] - 2.0) * s->v[2]);
            }
            if (n == 0) {
                before[0] = sum;
                before[1] = moment;
            } else {
                energy[k] = (sum + w.sums.elastic_normal) / before[0] - 1.0;
                spin[k] = moment - before[1];
            }
        }
        world_close(&w);
    }
    print_message("energy changes by %.2g with triangles and %.2g with a field, angular momentum by %.2g and "
                  "%.2g of %.2g\n",
                  energy[0], energy[1], spin[0], spin[1], before[1]);
    assert_true(fabs(energy[1]) < 1e-3 && fabs(spin[1]) < 0.02);
    mesh_free(&file);
    remove(path);
}

/* A sphere on a cube that moves and turns: the same force and springs as with triangles; it rolls over an edge. */
static void test_moving(void **state) {
    (void)state;
    char path[64];
    struct mesh file = cube();
    double force[2][6], place[2][3];
    stl(path, "cube.stl", &file);
    for (int k = 0; k < 2; k++) {
        struct wall_options wall = hand_mesh(path);
        struct world w;
        wall.field = k == 1;
        wall.field_spacing = 0.05;
        wall.scale = 0.5;
        for (int d = 0; d < 3; d++)
            wall.offset[d] = 2.0;
        wall.motions = 2;
        wall.motion[0] = (struct wall_motion){.kind = WALL_ROTATE,
                                              .stop = INFINITY,
                                              .direction = {0.0, 0.0, 1.0},
                                              .point = {2.0, 2.0, 0.0},
                                              .rate = 1.0};
        wall.motion[1] =
            (struct wall_motion){.kind = WALL_TRANSLATE, .stop = INFINITY, .velocity = {0.2, 0.0, 0.05}};
        world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.4), &wall, 1, 1);
        w.motion.gravity[2] = -10.0;
        world_add(&w, 2.1, 2.0, 2.5 + 0.15 - 2e-5, 0.15, 0.02);
        world_build(&w);
        for (int n = 0; n < 5000; n++)
            world_step(&w, n % 25 == 0, NULL);
        walls_forces(w.walls, &force[k]);
        memcpy(place[k], w.particles->state[0].x, sizeof place[k]);
        assert_int_equal(w.sums.contacts, 1);
        world_close(&w);
    }
    print_message("the place of the sphere: %g %g %g and %g %g %g\n", place[0][0], place[0][1], place[0][2],
                  place[1][0], place[1][1], place[1][2]);
    for (int c = 0; c < 3; c++) {
        assert_near(force[1][c], force[0][c], 1e-9);
        assert_near(place[1][c], place[0][c], 1e-9);
    }
    mesh_free(&file);
    remove(path);
}

/* The foot of a place on a ball, as a fluid sees it: with a field the normal points along the radius, smoothly over facets; beyond the
 * tiles the triangles tell. */
static void test_foot(void **state) {
    (void)state;
    char path[64];
    struct mesh file = ball(1.0);
    double worst[2] = {0};
    stl(path, "ball.stl", &file);
    for (int k = 0; k < 2; k++) {
        struct wall_options wall = hand_mesh(path);
        struct world w;
        struct wall_foot foot;
        unsigned seed = 11;
        wall.field = k == 1;
        wall.field_spacing = 0.0625;
        for (int d = 0; d < 3; d++)
            wall.offset[d] = 2.0;
        world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 1);
        walls_cover(w.walls, 0.2);
        for (int n = 0; n < 400; n++) {
            double x[3], from[3], across[3], radius;
            for (int d = 0; d < 3; d++)
                from[d] = 2.0 * hand_random(&seed) - 1.0;
            radius = hand_length(from);
            for (int d = 0; d < 3; d++) {
                from[d] /= radius;
                x[d] = 2.0 + 0.98 * from[d];
            }
            walls_foot(w.walls, 0, x, 0.2, &foot);
            assert_near(foot.distance, -0.02, 2e-3);
            for (int d = 0; d < 3; d++)
                across[d] = foot.normal[d] - from[d];
            worst[k] = fmax(worst[k], hand_length(across));
        }
        walls_foot(w.walls, 0, (double[3]){2.2, 2.0, 2.0}, INFINITY, &foot);
        assert_near(foot.distance, -0.8, 2e-3);
        assert_near(foot.normal[0], 1.0, 0.02);
        walls_foot(w.walls, 0, (double[3]){3.5, 2.0, 2.0}, INFINITY, &foot);
        assert_near(foot.distance, 0.5, 2e-3);
        walls_foot(w.walls, 0, (double[3]){3.5, 2.0, 2.0}, 0.4, &foot);
        assert_true(isinf(foot.distance));
        world_close(&w);
    }
    print_message("normals are off by %.2g with triangles and %.2g with a field\n", worst[0], worst[1]);
    assert_true(worst[1] < 0.6 * worst[0] && worst[1] < 0.01);
    mesh_free(&file);
    remove(path);
}

static void test_refused(void **state) {
    (void)state;
    struct mesh file = cube();
    struct wall_field *field;
    struct error error = {0};
    struct wall_mesh *mesh = mesh_of(&file);
    assert_false(wall_field_create(&field, mesh, 2.0 / 4096, "cube", &error));
    assert_non_null(strstr(error.text, "wall 'cube': field_spacing is"));
    assert_true(wall_field_create(&field, mesh, NAN, "cube", &error));
    assert_near(wall_field_look(field).spacing, 2.0 / 128, 1e-15);
    wall_field_destroy(&field);
    wall_mesh_destroy(&mesh);
    file.count--;
    mesh = mesh_of(&file);
    error = (struct error){0};
    assert_false(wall_field_create(&field, mesh, 0.1, "cube", &error));
    assert_non_null(strstr(error.text, "3 edges are not shared"));
    wall_mesh_destroy(&mesh);
    mesh_free(&file);
}

TEST_MAIN(wall_field, cmocka_unit_test(test_ball), cmocka_unit_test(test_cube), cmocka_unit_test(test_smooth),
          cmocka_unit_test(test_bowl), cmocka_unit_test(test_moving), cmocka_unit_test(test_foot),
          cmocka_unit_test(test_refused))
