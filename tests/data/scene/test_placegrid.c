/* SPDX-License-Identifier: BSD-3-Clause */
/* The grid of placed spheres against brute force. */
#include "tests/test.h"

#include "data/scene/placegrid.h"

#include "base/random.h"

#include <math.h>

enum { SPHERES = 600, QUERIES = 2000 };

struct sphere {
    double x[3], r;
};

/* Radii over `ratio`, mostly small; positions over the box, beyond it where it is open. */
static struct sphere draw(const struct box *box, double ratio, uint64_t item) {
    struct random_sequence random = random_sequence(11, RANDOM_TEST, item);
    struct sphere sphere;
    double u = random_uniform(&random);
    sphere.r = 0.05 * pow(ratio, u * u * u);
    for (int d = 0; d < 3; d++) {
        double stretch = box->periodic[d] ? 1 : 1.5;
        sphere.x[d] = box->edge[d] * (0.5 + stretch * (random_uniform(&random) - 0.5));
    }
    return sphere;
}

static bool touches(const struct box *box, const struct sphere *a, const struct sphere *b) {
    double nearest = INFINITY;
    for (int code = 0; code < 27; code++) {
        double sum = 0;
        int shift[3] = {code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
        for (int d = 0; d < 3; d++) {
            double gap = a->x[d] - b->x[d] + (box->periodic[d] ? shift[d] * box->edge[d] : 0);
            sum += gap * gap;
        }
        nearest = fmin(nearest, sum);
    }
    return nearest < (a->r + b->r) * (a->r + b->r);
}

static void compare(const struct box *box, double ratio) {
    struct placegrid *grid = placegrid_create(box, 0.05);
    struct sphere placed[SPHERES];
    int found = 0;
    for (int k = 0; k < SPHERES; k++) {
        placed[k] = draw(box, ratio, (uint64_t)k);
        placegrid_add(grid, placed[k].x, placed[k].r);
    }
    for (int q = 0; q < QUERIES; q++) {
        struct sphere query = draw(box, 1 + q % 3, (uint64_t)(SPHERES + q));
        bool expected = false;
        for (int k = 0; k < SPHERES && !expected; k++)
            expected = touches(box, &placed[k], &query);
        assert_int_equal(placegrid_touches(grid, query.x, query.r), expected);
        found += expected;
    }
    assert_true(found > QUERIES / 100 && found < QUERIES);
    placegrid_destroy(&grid);
    assert_null(grid);
}

static void against_brute_force(void **state) {
    (void)state;
    struct box open = {.dimension = 3, .edge = {4, 4, 4}};
    struct box periodic = {.dimension = 3, .edge = {4, 4.3, 3.7}, .periodic = {true, true, true}};
    struct box mixed = {.dimension = 3, .edge = {8, 0.7, 4}, .periodic = {false, true, false}};
    compare(&open, 1);
    compare(&open, 20);
    compare(&periodic, 1);
    compare(&periodic, 20);
    compare(&mixed, 6);
}

/* Spheres that just touch do not overlap. */
static void touching_is_allowed(void **state) {
    (void)state;
    struct box box = {.dimension = 3, .edge = {10, 10, 10}};
    struct placegrid *grid = placegrid_create(&box, 1);
    assert_false(placegrid_touches(grid, (double[3]){1, 1, 1}, 1));
    placegrid_add(grid, (double[3]){1, 1, 1}, 1);
    assert_false(placegrid_touches(grid, (double[3]){3, 1, 1}, 1));
    assert_true(placegrid_touches(grid, (double[3]){2.999, 1, 1}, 1));
    assert_true(placegrid_touches(grid, (double[3]){1, 1, 1}, 1e-6));
    placegrid_destroy(&grid);
}

TEST_MAIN(placegrid, cmocka_unit_test(against_brute_force), cmocka_unit_test(touching_is_allowed))
