/* SPDX-License-Identifier: BSD-3-Clause */
/* The weights of particles beside walls: their sum over the planes of a lattice is the room, wherever the walls lie. */
#include "tests/test.h"

#include "physics/fluid/carried/layer.h"
#include <math.h>
#include "tests/near.h"

/* The sum over planes one apart, from the first one at a distance `from` to the other wall. */
static double sum_of(double from, double gap, double end) {
    double sum = 0;
    for (double d = from; d < end; d += 1)
        sum += layer_part(d, gap);
    return sum;
}

/* One wall: planes up to a place where nothing looks stand for the room up to half a spacing beyond the last. */
static void test_wall(void **state) {
    (void)state;
    assert_float_equal(layer_part(LAYER_REACH, INFINITY), 1, 1e-12);
    assert_float_equal(layer_part(7, INFINITY), 1, 1e-12);
    for (double from = 0.05; from < 1; from += 0.05)
        assert_float_equal(sum_of(from, INFINITY, 8.47), floor(8.47 - from) + from + 0.5, LAYER_LEAST);
    /* without the least weight it is exact */
    for (double from = 0.2; from < 1; from += 0.05)
        assert_float_equal(sum_of(from, INFINITY, 8.47), floor(8.47 - from) + from + 0.5, 1e-12);
}

/* Planes at an angle to a square lattice, (1, 1) and (2, 1): nearly so, where counting is up to half a distance of planes off. */
static void test_angle(void **state) {
    (void)state;
    const double apart[] = {sqrt(0.5), sqrt(0.2)}, within[] = {0.08, 0.03};
    for (int k = 0; k < 2; k++)
        for (double from = 0.02; from < apart[k]; from += 0.02) {
            double sum = 0, d = from;
            for (; d < 6; d += apart[k])
                sum += apart[k] * layer_part(d, INFINITY);
            assert_float_equal(sum, d - 0.5 * apart[k], within[k]);
        }
}

/* Gaps of one spacing or more. */
static void test_gap(void **state) {
    (void)state;
    for (double gap = 1.05; gap < 6; gap += 0.05)
        for (double from = 0.01; from < 1; from += 0.01) {
            assert_float_equal(sum_of(from, gap, gap), gap, 2 * LAYER_LEAST + 1e-3);
            assert_float_equal(layer_part(from, gap), layer_part(gap - from, gap), 1e-9);
        }
    assert_float_equal(layer_part(0.3, 0.9), 1, 1e-12);
}

TEST_MAIN(fluid_layer, cmocka_unit_test(test_wall), cmocka_unit_test(test_angle), cmocka_unit_test(test_gap))
