/* SPDX-License-Identifier: BSD-3-Clause */
/* Shapes of bodies against closed forms: masses of members, principal axes, the inertia that members lack. */
#include "tests/test.h"

#include "physics/bodies/clump.h"
#include "base/rotor.h"
#include <math.h>
#include <string.h>
#include "tests/near.h"
#include "tests/scene_by_hand.h"

static const struct scene space = {.box = {.dimension = 3}};

static struct clump_options of_spheres(int spheres, const double (*sphere)[4]) {
    struct clump_options options = {.spheres = spheres, .scale = 1, .entry = {.mass = NAN}};
    for (int k = 0; k < spheres; k++) {
        memcpy(options.sphere[k].centre, sphere[k], sizeof options.sphere[k].centre);
        options.sphere[k].radius = sphere[k][3];
    }
    return options;
}

/* Shares add up to 1, and put the centre of mass at the origin. */
static void check_shares(const struct clump *clump) {
    double sum = 0, moment[3] = {0};
    for (int k = 0; k < clump->spheres; k++) {
        sum += clump->share[k];
        for (int d = 0; d < 3; d++)
            moment[d] += clump->share[k] * clump->sphere[k].centre[d];
    }
    assert_near(sum, 1, 1e-14);
    for (int d = 0; d < 3; d++)
        assert_near(moment[d], 0, 1e-14 * clump->extent);
}

/* Two spheres that touch, on a slanted line, volumes 1 : 8. */
static void dumbbell(void **state) {
    const double sphere[2][4] = {{5, 1, 1, 1}, {5 + 1.8, 1 + 2.4, 1, 2}};
    struct clump_options options = of_spheres(2, sphere);
    struct clump clump;
    struct error error = {0};
    (void)state;
    assert_true(clump_make(&clump, &space, 0, &options, &error));
    check_shares(&clump);
    assert_true(!clump.overlap && clump.rest[0] == 0 && clump.rest[4] == 0);
    assert_near(clump.volume, 4 * M_PI / 3 * 9, 1e-12);
    assert_near(clump.share[0], 1.0 / 9, 1e-14);
    assert_near(clump.extent, 8.0 / 3 + 1, 1e-14); /* of the small one, whose centre is 8/9 of 3 away */
    double along = 0.4 * (1 + 8 * 4) / 9, across = along + 8.0 / 9 * 3 * 3 / 9;
    assert_near(clump.gyration[0], along, 1e-13);
    assert_near(clump.gyration[1], across, 1e-13);
    assert_near(clump.gyration[2], across, 1e-13);
    double turn[9], back[3]; /* the axes turn the members to where the entry has them, but for the centre */
    rotor_matrix(clump.axes, turn);
    rotor_turn(turn, clump.sphere[0].centre, back);
    assert_near(back[0], -8.0 / 9 * 1.8, 1e-13);
    assert_near(back[1], -8.0 / 9 * 2.4, 1e-13);
    assert_near(clump_mass(&clump, 0.5, 3), 3 * clump.volume / 8, 1e-13);
    clump_free(&clump);
}

/* A given centre and inertia: shares lean towards the centre, and `rest` is what they lack. */
static void given_centre(void **state) {
    const double sphere[2][4] = {{-1, 0, 0, 1}, {1, 0, 0, 1}};
    struct clump_options options = of_spheres(2, sphere);
    struct clump clump;
    struct error error = {0};
    (void)state;
    options.entry.mass = 4;
    options.centre_given = 3;
    options.centre[0] = 0.5;
    options.inertia_given = 6;
    memcpy(options.inertia, (double[6]){4, 8, 8, 0, 0, 0}, sizeof options.inertia);
    assert_true(clump_make(&clump, &space, 0, &options, &error));
    check_shares(&clump);
    bool first = fabs(clump.sphere[0].centre[0]) > 1;
    assert_near(first ? clump.share[0] : clump.share[1], 0.25, 1e-14); /* the one 1.5 away */
    assert_near(clump.gyration[0], 1, 1e-14);
    assert_near(clump.rest[0], 1 - 0.4, 1e-14);
    assert_near(clump.rest[4], 2 - 0.4 - (0.25 * 2.25 + 0.75 * 0.25), 1e-14);
    assert_near(clump_mass(&clump, 2, 77), 32, 1e-13);
    clump_free(&clump);
}

/* Members that have more inertia than the body is given: its contacts turn it more easily than they would turn them. */
static void light(void **state) {
    const double sphere[2][4] = {{-1, 0, 0, 1}, {1, 0, 0, 1}};
    struct clump_options options = of_spheres(2, sphere);
    struct clump clump;
    struct error error = {0};
    (void)state;
    assert_true(clump_make(&clump, &space, 0, &options, &error));
    assert_near(clump.ease, 1, 1e-14);
    clump_free(&clump);
    options.entry.mass = 1;
    options.inertia_given = 6;
    memcpy(options.inertia, (double[6]){0.2, 0.35, 0.35, 0, 0, 0}, sizeof options.inertia);
    assert_true(clump_make(&clump, &space, 0, &options, &error));
    assert_near(clump.ease, 1.4 / 0.35, 1e-7);
    clump_free(&clump);
}

static void refused(void **state) {
    const double flat[2][4] = {{0, 0, 0, 1}, {1, 0, 0.1, 1}}, far[2][4] = {{-1, 0, 0, 1}, {1, 0, 0, 1}};
    struct clump_options options = of_spheres(2, flat);
    struct scene *scene = good_scene(GOOD_SCENE, NULL);
    struct clump clump;
    struct error error = {0};
    (void)state;
    scene->box.dimension = 2;
    assert_false(clump_make(&clump, scene, 3, &options, &error));
    assert_non_null(strstr(error.text, "bodies.clumps[3].spheres: in two dimensions"));
    clump_free(&clump);
    options = of_spheres(2, far);
    options.entry.mass = 1;
    options.inertia_given = 6;
    memcpy(options.inertia, (double[6]){1, 1, 3, 0, 0, 0}, sizeof options.inertia);
    error = (struct error){0};
    scene->box.dimension = 3;
    assert_false(clump_make(&clump, scene, 0, &options, &error));
    assert_non_null(strstr(error.text, "no body has such moments"));
    clump_free(&clump);
    scene_free(&scene);
}

TEST_MAIN(clump, cmocka_unit_test(dumbbell), cmocka_unit_test(given_centre), cmocka_unit_test(light),
          cmocka_unit_test(refused))
