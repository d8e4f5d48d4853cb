/* SPDX-License-Identifier: BSD-3-Clause */
/* The factor of a drive over time. */
#include "tests/test.h"

#include "physics/fluid/schemes/flow_drive.h"
#include <math.h>
#include "near.h"

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

TEST_MAIN(fluid_drive, cmocka_unit_test(test_factor))
