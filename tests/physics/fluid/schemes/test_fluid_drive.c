/* SPDX-License-Identifier: BSD-3-Clause */
/* The factor of a drive over time. */
#include "tests/test.h"

#include "physics/fluid/schemes/flow_drive.h"
#include <math.h>
#include "tests/near.h"

static void test_factor(void **state) {
    double value[] = {0.5, 1, 1.0, 3, 2.0, -1, 2.5, 1};
    const struct numbers none = {0}, table = {.rows = 4, .columns = 2, .value = value},
                         one = {.rows = 1, .columns = 2, .value = value};
    (void)state;
    assert_float_equal(flow_drive_factor(&none, false, 7), 1, 0);
    assert_float_equal(flow_drive_factor(&one, false, -3) + flow_drive_factor(&one, false, 3), 2, 0);
    assert_float_equal(flow_drive_factor(&table, false, 0), 1, 0);
    assert_float_equal(flow_drive_factor(&table, false, 0.75), 2, 1e-15);
    assert_float_equal(flow_drive_factor(&table, false, 1), 3, 1e-15);
    assert_float_equal(flow_drive_factor(&table, false, 1.25), 2, 1e-15);
    assert_float_equal(flow_drive_factor(&table, false, 2.25), 0, 1e-15);
    value[7] = 5;
    assert_float_equal(flow_drive_factor(&table, false, 9), 5, 0);
    value[7] = 1;
    for (int period = -3; period < 4; period++)
        for (double t = 0.5; t < 2.5; t += 0.1)
            assert_float_equal(flow_drive_factor(&table, true, t + 2 * period),
                               flow_drive_factor(&table, false, t), 1e-12);
}

/* A pressure drop acts over the edge along its own axis. */
static void test_drop(void **state) {
    const struct box box = {.dimension = 3, .edge = {2, 4, 8}, .periodic = {true, true, true}};
    struct fluid_options options = {.drive = {.pressure_drop = 3, .mass_flow = NAN}};
    struct error error = {0};
    (void)state;
    for (int axis = 0; axis < 3; axis++) {
        options.drive.axis = axis;
        struct drive drive = flow_drive_begin(&options, &box, &error);
        for (int d = 0; d < 3; d++)
            assert_float_equal(drive.force[d], d == axis ? 3 / box.edge[d] : 0, 1e-15);
        flow_drive_free(&drive);
    }
    assert_int_equal(error.kind, ERROR_NONE);
}

TEST_MAIN(fluid_drive, cmocka_unit_test(test_factor), cmocka_unit_test(test_drop))
