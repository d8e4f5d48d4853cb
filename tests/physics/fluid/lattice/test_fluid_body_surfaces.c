/* SPDX-License-Identifier: BSD-3-Clause */
/* Feet on spheres and discs, depths behind tangent planes, and the numbers of bodies. */
#include "tests/test.h"

#include <math.h>

#include "tests/near.h"
#include "physics/fluid/lattice/body_surfaces.h"

static const double velocity[3] = {1, -2, 0.5}, omega[3] = {0.3, 0.7, -1.1};

/* Outside and inside: |away| - R, the direction of `away`, and v + omega x away. */
static void a_sphere_has_its_nearest_point(void **state) {
    static const double away[3] = {2, -3, 6}; /* of length 7 */
    (void)state;
    for (int inside = 0; inside < 2; inside++) {
        struct weights_foot foot = {0};
        double radius = inside ? 9 : 4;
        body_sphere_foot(away, radius, 3, velocity, omega, &foot);
        assert_near(foot.distance, 7 - radius, 1e-14);
        for (int d = 0; d < 3; d++) {
            assert_near(foot.normal[d], away[d] / 7, 1e-15);
            assert_near(foot.velocity[d],
                        velocity[d] + omega[(d + 1) % 3] * away[(d + 2) % 3] -
                            omega[(d + 2) % 3] * away[(d + 1) % 3],
                        1e-13);
            assert_true(foot.spin[d] == omega[d]);
        }
    }
}

/* In two dimensions the third component does not count; without a spin the velocity is that of the centre; at the centre the normal is x. */
static void a_disc_and_the_centre(void **state) {
    struct weights_foot foot = {0};
    (void)state;
    body_sphere_foot((double[3]){3, 4, 100}, 2, 2, velocity, NULL, &foot);
    assert_near(foot.distance, 3, 1e-14);
    assert_near(foot.normal[0], 0.6, 1e-15);
    assert_near(foot.normal[1], 0.8, 1e-15);
    assert_true(foot.normal[2] == 0 && foot.spin[0] == 0 && foot.spin[2] == 0);
    for (int d = 0; d < 3; d++)
        assert_true(foot.velocity[d] == velocity[d]);
    body_sphere_foot((double[3]){0, 0, 0}, 2, 3, velocity, omega, &foot);
    assert_true(foot.distance == -2 && foot.normal[0] == 1 && foot.normal[1] == 0 && foot.normal[2] == 0);
}

/* With the foot 2 below x_i, x_j 5 below lies 3 behind the plane, whatever it is aside; above the plane the depth is 0. */
static void depth_behind_the_plane(void **state) {
    const struct weights_foot foot = {.distance = 2, .normal = {0, 0.6, 0.8}};
    (void)state;
    assert_near(body_behind(&foot, (double[3]){7, -3, -4}), 3, 1e-14);
    assert_near(body_behind(&foot, (double[3]){-9, -0.6 * 2.5 + 0.8, -0.8 * 2.5 - 0.6}), 0.5, 1e-14);
    assert_true(body_behind(&foot, (double[3]){0, 0, -1}) == 0);
    assert_true(body_behind(&foot, (double[3]){0, 3, 4}) == 0);
}

static void numbers_come_back(void **state) {
    (void)state;
    for (int wall = 0; wall < WALLS_MAX; wall++) {
        assert_int_equal(body_wall(body_of_wall(wall)), wall);
        assert_int_equal(body_side(body_of_wall(wall)), -1);
        assert_true(body_of_wall(wall) < BODY_NONE);
    }
    for (int side = 0; side < 6; side++)
        assert_int_equal(body_side(body_of_side(side)), side);
    assert_int_equal(body_side(17), -1);
}

TEST_MAIN(fluid_body_surfaces, cmocka_unit_test(a_sphere_has_its_nearest_point),
          cmocka_unit_test(a_disc_and_the_centre), cmocka_unit_test(depth_behind_the_plane),
          cmocka_unit_test(numbers_come_back))
