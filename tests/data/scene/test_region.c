/* SPDX-License-Identifier: BSD-3-Clause */
/* Regions: what they contain, their volumes, points drawn from them. */
#include "tests/test.h"

#include "data/scene/region.h"

#include <math.h>

static const struct region_space solid = {.dimension = 3};
static const struct region regions[] = {
    {.shape = REGION_BOX, .lower = {0, 1, -1}, .upper = {2, 3, 1}},
    {.shape = REGION_SPHERE, .centre = {1, 2, 3}, .radius = 1.5},
    {.shape = REGION_CYLINDER, .centre = {0, 1, 0}, .axis = {0, 0, 1}, .radius = 1, .length = 4},
    {.shape = REGION_CYLINDER, .centre = {0, 1, 0}, .axis = {0.6, 0, 0.8}, .radius = 1, .length = 4},
};
enum { REGIONS = sizeof(regions) / sizeof(regions[0]) };

static void contains(void **state) {
    (void)state;
    assert_true(region_contains(&regions[0], &solid, (double[3]){0, 1, -1}, 0));
    assert_false(region_contains(&regions[0], &solid, (double[3]){2, 2, 0}, 0));
    assert_false(region_contains(&regions[0], &solid, (double[3]){0.1, 2, 0}, 0.2));
    assert_true(region_contains(&regions[0], &solid, (double[3]){0.25, 2, 0}, 0.2));
    struct region_space wrapped = {.dimension = 3, .wrap = {true, false, false}};
    assert_true(region_contains(&regions[0], &wrapped, (double[3]){0.1, 2, 0}, 0.2));
    assert_true(region_contains(&regions[1], &solid, (double[3]){1, 2, 4.4}, 0));
    assert_false(region_contains(&regions[1], &solid, (double[3]){1, 2, 4.4}, 0.2));
    assert_true(region_contains(&regions[3], &solid, (double[3]){1.19, 1, 1.59}, 0));
    assert_false(region_contains(&regions[3], &solid, (double[3]){1.21, 1, 1.61}, 0));
    struct region_space flat = {.dimension = 2};
    assert_true(region_contains(&regions[0], &flat, (double[3]){1, 2, 99}, 0));
    assert_true(region_contains(&regions[2], &flat, (double[3]){0, 1, 99}, 0));
    struct region all = {.shape = REGION_ALL};
    assert_true(region_contains(&all, &solid, (double[3]){1e9, 0, 0}, 3));
}

/* Volume by counting points of the bounding box; points outside of it are never inside. */
static void volumes(void **state) {
    (void)state;
    for (int k = 0; k < REGIONS; k++) {
        double lower[3], upper[3], box = 1;
        region_bounds(&regions[k], lower, upper);
        for (int d = 0; d < 3; d++)
            box *= (upper[d] - lower[d]) * 1.2;
        int inside = 0, tries = 200000;
        for (int n = 0; n < tries; n++) {
            struct random_sequence random = random_sequence(1, RANDOM_TEST, (uint64_t)n);
            double x[3];
            bool in_bounds = true;
            for (int d = 0; d < 3; d++) {
                x[d] = lower[d] + (upper[d] - lower[d]) * (1.2 * random_uniform(&random) - 0.1);
                in_bounds = in_bounds && x[d] >= lower[d] && x[d] <= upper[d];
            }
            bool in = region_contains(&regions[k], &solid, x, 0);
            assert_true(in_bounds || !in);
            inside += in;
        }
        double volume = region_volume(&regions[k], &solid);
        assert_true(fabs(box * inside / tries - volume) < 0.02 * volume);
    }
    struct region_space flat = {.dimension = 2};
    assert_true(region_volume(&regions[0], &flat) == 4);
    assert_true(fabs(region_volume(&regions[1], &flat) - M_PI * 2.25) < 1e-12);
    assert_true(fabs(region_volume(&regions[2], &flat) - M_PI) < 1e-12);
}

/* Drawn spheres lie inside, and fill the region evenly: their mean is its centre. */
static void draws(void **state) {
    (void)state;
    for (int k = 0; k < REGIONS; k++) {
        struct random_sequence random = random_sequence(2, RANDOM_TEST, (uint64_t)k);
        double mean[3] = {0, 0, 0}, lower[3], upper[3];
        enum { N = 20000 };
        for (int n = 0; n < N; n++) {
            double x[3];
            assert_true(region_draw(&regions[k], &solid, 0.3, &random, x));
            assert_true(region_contains(&regions[k], &solid, x, 0.3 * (1 - 1e-12)));
            for (int d = 0; d < 3; d++)
                mean[d] += x[d] / N;
        }
        region_bounds(&regions[k], lower, upper);
        for (int d = 0; d < 3; d++)
            assert_true(fabs(mean[d] - (lower[d] + upper[d]) / 2) < 0.03);
        double x[3];
        assert_false(region_draw(&regions[k], &solid, 5, &random, x));
    }
    struct region_space flat = {.dimension = 2, .plane = 0.25};
    struct random_sequence random = random_sequence(2, RANDOM_TEST, 99);
    double x[3];
    assert_true(region_draw(&regions[0], &flat, 0.3, &random, x));
    assert_true(x[2] == 0.25);
}

/* A sphere as large as the inscribed one has a place, a larger one has none. */
static void holds(void **state) {
    (void)state;
    const struct region box = {.shape = REGION_BOX, .lower = {-1, 0, 0}, .upper = {7, 4, 2}};
    const struct region coin = {
        .shape = REGION_CYLINDER, .centre = {1, 1, 1}, .axis = {0, 0, 1}, .radius = 3, .length = 4};
    const struct region sphere = {.shape = REGION_SPHERE, .centre = {1, 1, 1}, .radius = 1.5};
    const struct region all = {.shape = REGION_ALL};
    const struct region_space flat = {.dimension = 2}, tube = {.dimension = 3, .wrap = {false, true, true}};
    const struct region_space torus = {.dimension = 3, .wrap = {true, true, true}};
    const struct {
        const struct region *region;
        const struct region_space *space;
        double radius;
    } cases[] = {{&box, &solid, 1}, {&box, &flat, 2},       {&box, &tube, 4},     {&coin, &solid, 2},
                 {&coin, &flat, 3}, {&sphere, &solid, 1.5}, {&sphere, &flat, 1.5}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        struct random_sequence random = random_sequence(3, RANDOM_TEST, k);
        double x[3], radius = region_inradius(cases[k].region, cases[k].space);
        assert_true(radius == cases[k].radius);
        assert_true(region_draw(cases[k].region, cases[k].space, 0.9 * radius, &random, x));
        assert_false(region_draw(cases[k].region, cases[k].space, 1.0001 * radius, &random, x));
    }
    assert_true(isinf(region_inradius(&all, &solid)) && isinf(region_inradius(&box, &torus)));
}

TEST_MAIN(region, cmocka_unit_test(holds), cmocka_unit_test(contains), cmocka_unit_test(volumes),
          cmocka_unit_test(draws))
