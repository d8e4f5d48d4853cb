/* SPDX-License-Identifier: BSD-3-Clause */
/* Scenes beside those that are refused (test_scene_check.c): these are good. */
#include "tests/scene_by_hand.h"

/* What stays in the plane is good. */
static void good_planes(void **state) {
    (void)state;
    const char *const set[] = {
        "box.dimension=2",
        "gravity=[0, -9.81]",
        "insertions=[{sizes: 1 mm, rate: 3, velocity: [1, 2], omega: [0, 0, 3]}]",
        "walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}",
        "walls[1]={shape: plane, point: [0, 0, 20 mm], normal: [0, 0, -1]}",
        "walls[2]={shape: cylinder, point: [5 mm, 5 mm, 0], axis: [0, 0, 1], radius: 4 mm, motion: [{kind: "
        "rotate, direction: [0, 0, 1], rate: 1}, {kind: oscillate, direction: [1, 1], amplitude: 1 mm, "
        "frequency: 1}]}",
        NULL};
    struct scene *scene = good_scene(GOOD_SCENE, set);
    assert_int_equal(scene->walls, 3);
    scene_free(&scene);
}

/* Spheres may be placed in a region as long as a periodic edge, and in any where the box is open; what is
 * selected may lie in any. */
static void good_regions(void **state) {
    (void)state;
    const char *const set[] = {
        "box.periodic=[true, false, false]",
        "particles={from: random, sizes: 1 mm, count: 3, region: {shape: box, lower: [2.1 mm, -10 mm, 0], "
        "upper: [12.1 mm, 20 mm, 20 mm]}}",
        "groups=[{name: low, select: {region: {shape: box, lower: [-1, 0, 0], upper: [1, 1, 1 mm]}}}]",
        "deletions=[{region: {shape: sphere, centre: [0, 0, 0], radius: 1}}]", NULL};
    struct scene *scene = good_scene(GOOD_SCENE, set);
    assert_int_equal(scene->deletions, 1);
    scene_free(&scene);
}

/* Cylinders that a periodic box does not cut. */
static void good_cylinders(void **state) {
    (void)state;
    const char *const set[] = {
        "box.periodic=[true, false, true]",
        "walls[0]={shape: cylinder, point: [5 mm, 5 mm, 10 mm], axis: [0, 1, 0], radius: 4 mm}",
        "walls[1]={shape: cylinder, point: [5 mm, 5 mm, 0], axis: [1e-14, 0, 3], radius: 4 mm}",
        "walls[2]={shape: cylinder, point: [5 mm, 5 mm, 0], axis: [0, 0, 1], radius: 4 mm, length: 20 mm}",
        "walls[3]={shape: cylinder, point: [5 mm, 5 mm, 10 mm], axis: [1, 1, 1], radius: 1 mm, length: 9 mm}",
        NULL};
    struct scene *scene = good_scene(GOOD_SCENE, set);
    assert_int_equal(scene->walls, 4);
    scene_free(&scene);
}

TEST_MAIN(scene_allowed, cmocka_unit_test(good_planes), cmocka_unit_test(good_regions),
          cmocka_unit_test(good_cylinders))
