/* SPDX-License-Identifier: BSD-3-Clause */
/* How deep places lie in the solids of walls that move: a box that turns, across periodic sides, and a rod, against closed forms. */
#include "tests/test.h"

#include "tests/near.h"
#include "tests/physics/grains/walls/mesh_by_hand.h"

static const double half[3] = {0.7, 0.4, 0.3}, turn = 0.8, edge = 3;

/* The signed distance from the box about the origin. */
static double box_distance(const double x[3]) {
    double square = 0, inside = -INFINITY;
    for (int d = 0; d < 3; d++) {
        double out = fabs(x[d]) - half[d];
        square += out > 0 ? out * out : 0;
        inside = fmax(inside, out);
    }
    return inside > 0 ? sqrt(square) : inside;
}

static double cut(double distance, double reach) {
    return fmax(-reach, fmin(reach, distance));
}

/* The nearest image of the box in the box of the scene, which is periodic along x and y: the distance, and the way from its middle. */
static double nearest(const double x[3], const double centre[3], double arm[3]) {
    double least = INFINITY;
    for (int k = 0; k < 9; k++) {
        double from[3], own[3];
        for (int d = 0; d < 3; d++)
            from[d] = x[d] - centre[d] - (d == 0 ? edge * (k % 3 - 1) : d == 1 ? edge * (k / 3 - 1) : 0);
        own[0] = cos(turn) * from[0] + sin(turn) * from[1];
        own[1] = -sin(turn) * from[0] + cos(turn) * from[1];
        own[2] = from[2];
        if (!(box_distance(own) < least))
            continue;
        least = box_distance(own);
        memcpy(arm, from, sizeof from);
    }
    return least;
}

static void box_turned(double reach) {
    struct box box = hand_box(edge);
    struct wall_options paddle = {.name = "paddle", .shape = WALL_BOX, .motions = 1};
    const double centre[3] = {0.2, 2.8, 1.4};
    struct world w;
    unsigned seed = 3;
    int deep = 0, near = 0;
    box.periodic[0] = box.periodic[1] = true;
    for (int d = 0; d < 3; d++) {
        paddle.lower[d] = centre[d] - half[d];
        paddle.upper[d] = centre[d] + half[d];
    }
    paddle.motion[0] = (struct wall_motion){.kind = WALL_ROTATE,
                                            .start = 0,
                                            .stop = INFINITY,
                                            .direction = {0, 0, 1},
                                            .point = {centre[0], centre[1], centre[2]},
                                            .rate = turn};
    world_open(&w, box, hand_law(LAW_HOOKE, 1.0, 0), &paddle, 1, 1);
    assert_true(walls_bounded(w.walls, 0));
    walls_depth_prepare(w.walls, 0, reach);
    walls_advance(w.walls, 0, 1, NULL);
    for (int k = 0; k < 20000; k++) {
        double x[3], arm[3], wanted[3] = {0}, distance, depth;
        for (int d = 0; d < 3; d++)
            x[d] = edge * hand_random(&seed);
        distance = nearest(x, centre, wanted);
        depth = walls_depth(w.walls, 0, x, arm);
        assert_near(depth, cut(distance, reach), 1e-6);
        deep += distance < -1.2 * reach;
        near += fabs(distance) < reach;
        for (int d = 0; d < 3 && distance < reach; d++)
            assert_near(arm[d], wanted[d], 1e-9);
    }
    assert_true(deep > 50 && near > 200);
    world_close(&w);
}

/* With the second reach the sides are multiples of it. */
static void a_box_that_turns(void **state) {
    (void)state;
    box_turned(0.05);
    box_turned(0.1);
    box_turned(0.1 / 0.9);
}

static void a_rod_and_what_has_no_end(void **state) {
    (void)state;
    struct wall_options wall[3] = {{.name = "rod",
                                    .shape = WALL_CYLINDER,
                                    .point = {1, 1, 1.5},
                                    .axis = {0, 0, 1},
                                    .radius = 0.4,
                                    .length = 2},
                                   {.name = "bore",
                                    .shape = WALL_CYLINDER,
                                    .point = {1, 1, 1.5},
                                    .axis = {0, 0, 1},
                                    .radius = 1,
                                    .inside = true},
                                   hand_plane(0, 0, 0, 0, 0, 1)};
    struct world w;
    unsigned seed = 5;
    world_open(&w, hand_box(edge), hand_law(LAW_HOOKE, 1.0, 0), wall, 3, 1);
    assert_true(walls_bounded(w.walls, 0));
    assert_false(walls_bounded(w.walls, 1));
    assert_false(walls_bounded(w.walls, 2));
    walls_depth_prepare(w.walls, 0, 0.1);
    for (int k = 0; k < 2000; k++) {
        double x[3], arm[3];
        for (int d = 0; d < 3; d++)
            x[d] = edge * hand_random(&seed);
        double across = hypot(x[0] - 1, x[1] - 1) - 0.4, along = fabs(x[2] - 1.5) - 1;
        double distance = across > 0 && along > 0 ? hypot(across, along) : fmax(across, along);
        assert_near(walls_depth(w.walls, 0, x, arm), cut(distance, 0.1), 1e-9);
        assert_near(arm[0], x[0] - 1, 1e-12);
    }
    world_close(&w);
}

/* The same box with normals that point into it has no end: its solid is all around. */
static void a_box_inside_out(void **state) {
    (void)state;
    struct hand_text text = text_new();
    const double corner[4][3] = {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}};
    static const int side[2][4][3] = {{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
                                      {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
    for (int way = 0; way < 2; way++) {
        char path[64];
        struct world w;
        text.size = 0;
        for (int k = 0; k < 4; k++)
            text_triangle(&text, corner[side[way][k][0]], corner[side[way][k][1]], corner[side[way][k][2]]);
        struct wall_options mesh = hand_mesh(hand_file(path, "tetrahedron", text.text, text.size));
        world_open(&w, hand_box(edge), hand_law(LAW_HOOKE, 1.0, 0), &mesh, 1, 1);
        assert_int_equal(walls_bounded(w.walls, 0), way == 0);
        world_close(&w);
        remove(path);
    }
    memory_free(text.text);
}

TEST_MAIN(wall_depth, cmocka_unit_test(a_box_that_turns), cmocka_unit_test(a_rod_and_what_has_no_end),
          cmocka_unit_test(a_box_inside_out))
