/* SPDX-License-Identifier: BSD-3-Clause */
/* What is given at open sides and at listed surfaces: profiles, feet, and the surface on which a foot lies. */
#include "tests/test.h"

#include <math.h>

#include "tests/near.h"
#include "physics/fluid/schemes/boundary_values.h"
#include "physics/fluid/schemes/open_sides.h"

static const struct box box = {.dimension = 3, .edge = {4, 2, 5}, .periodic = {false, false, true}};

static struct fluid_options options_of(enum fluid_open_profile profile) {
    struct fluid_options options = {.opens = 2};
    options.open[0] =
        (struct fluid_open){.side = 0, .profile = profile, .velocity = {3, 4, 0}, .pressure = NAN};
    options.open[1] = (struct fluid_open){.side = 1, .velocity = {NAN, NAN, NAN}, .pressure = 7};
    return options;
}

/* A parabola over the walls alone: 4 s (1 - s) of s = y / 2, and nothing of x and of the periodic z. */
static void a_profile_is_a_parabola_between_walls(void **state) {
    struct fluid_options plug = options_of(FLUID_PLUG), curved = options_of(FLUID_PARABOLIC);
    (void)state;
    for (double y = 0; y <= 2; y += 0.125) {
        double velocity[3], x[3] = {0.3, y, 4.1};
        open_velocity(&plug.open[0], &box, x, velocity);
        assert_true(velocity[0] == 3 && velocity[1] == 4 && velocity[2] == 0);
        open_velocity(&curved.open[0], &box, x, velocity);
        for (int d = 0; d < 3; d++)
            assert_near(velocity[d], curved.open[0].velocity[d] * y * (2 - y), 1e-14);
    }
    double velocity[3];
    open_velocity(&curved.open[0], &box, (double[3]){0, 2.5, 0}, velocity); /* beyond the wall */
    assert_true(velocity[0] == 0);
    assert_near(open_speed(&plug), 5, 1e-15);
    assert_true(open_pressed(&plug) && open_at(&plug, 2) == NULL && open_at(&plug, 1) == &plug.open[1]);
}

static void a_foot_lies_on_its_side(void **state) {
    struct fluid_options options = options_of(FLUID_PLUG);
    struct weights_foot lower, upper;
    (void)state;
    open_foot(&options, &box, 0, (double[3]){0.5, 1, 2}, &lower);
    assert_true(lower.open && !lower.pressed && lower.normal[0] == 1 && lower.velocity[1] == 4);
    assert_near(lower.distance, 0.5, 0);
    open_foot(&options, &box, 1, (double[3]){0.5, 1, 2}, &upper);
    assert_true(upper.open && upper.pressed && upper.normal[0] == -1 && upper.pressure == 7);
    assert_near(upper.distance, 3.5, 0);
}

/* A wall, a group and a side, each found by its body alone. */
static void a_surface_is_found_by_its_body(void **state) {
    static const struct fluid_surface list[] = {{2, -1, -1}, {-1, 5, -1}, {-1, -1, 3}};
    (void)state;
    assert_int_equal(boundary_values_number(list, 3, body_of_wall(2), -1), 0);
    assert_int_equal(boundary_values_number(list, 3, body_of_wall(3), -1), -1);
    assert_int_equal(boundary_values_number(list, 3, body_of_side(3), -1), 2);
    assert_int_equal(boundary_values_number(list, 3, body_of_side(2), 5), -1);
    assert_int_equal(boundary_values_number(list, 3, 17, 5), 1);
    assert_int_equal(boundary_values_number(list, 3, 17, 2), -1);
    assert_int_equal(boundary_values_number(list, 3, 17, -1), -1);
    assert_int_equal(boundary_values_number(list, 3, BODY_NONE, 5), -1);
    assert_int_equal(boundary_values_number(list, 0, body_of_wall(2), 5), -1);
}

TEST_MAIN(fluid_open_sides, cmocka_unit_test(a_profile_is_a_parabola_between_walls),
          cmocka_unit_test(a_foot_lies_on_its_side), cmocka_unit_test(a_surface_is_found_by_its_body))
