/* SPDX-License-Identifier: BSD-3-Clause */
/* The flat surface of rounded solids: closed, with the right side outwards, of known volume. */
#include "tests/test.h"

#include "physics/bodies/shapes/chamfer.h"
#include "tests/near.h"
#include "tests/physics/bodies/shapes/solid_by_hand.h"

/* Number of polygons that run from corner a to corner b. */
static int runs(const struct chamfer *c, int a, int b) {
    int count = 0;
    for (int p = 0; p < c->polygons; p++)
        for (int k = c->start[p], last = c->start[p + 1] - 1; k <= last; k++)
            count += c->ring[k] == a && c->ring[k < last ? k + 1 : c->start[p]] == b;
    return count;
}

/* Each side of a polygon is one of exactly one other polygon, the other way round; V - E + F = 2. */
static void check_closed(const struct chamfer *c) {
    int sides = c->start[c->polygons];
    assert_int_equal(2 * (c->corners + c->polygons - 2), sides);
    for (int p = 0; p < c->polygons; p++) {
        assert_true(c->start[p + 1] - c->start[p] >= 3);
        for (int k = c->start[p], last = c->start[p + 1] - 1; k <= last; k++) {
            int a = c->ring[k], b = c->ring[k < last ? k + 1 : c->start[p]];
            assert_int_equal(runs(c, a, b), 1);
            assert_int_equal(runs(c, b, a), 1);
        }
    }
}

static double volume(const struct chamfer *c) {
    double sum = 0;
    for (int p = 0; p < c->polygons; p++)
        for (int k = c->start[p] + 2; k < c->start[p + 1]; k++) {
            const double *x = c->corner[c->ring[c->start[p]]], *y = c->corner[c->ring[k - 1]],
                         *z = c->corner[c->ring[k]];
            sum += x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
                   x[2] * (y[0] * z[1] - y[1] * z[0]);
        }
    return sum / 6;
}

/* A box with all edges and corners cut: six faces, twelve strips, eight triangles. */
static void box(void **state) {
    struct by_hand rock;
    struct chamfer c;
    const double a = 3, b = 2, d = 1, r = 0.2;
    (void)state;
    assert_true(by_hand_box(&rock, a, b, d, r));
    chamfer_make(&c, &rock.core, r);
    assert_int_equal(c.corners, 24);
    assert_int_equal(c.polygons, 26);
    check_closed(&c);
    assert_near(volume(&c),
                a * b * d + 2 * r * (a * b + b * d + d * a) + 2 * r * r * (a + b + d) + 4.0 / 3 * r * r * r,
                1e-13);
    chamfer_free(&c);
    solid_free(&rock.core);
}

/* Random rocks, with corners where many faces meet: between the core and what is nearer than the rounding to it. */
static void rocks(void **state) {
    struct random_sequence random = random_sequence(3, RANDOM_SHAPE, 1);
    struct by_hand rock;
    struct moments moments;
    struct chamfer c;
    (void)state;
    for (int n = 0; n < 20; n++) {
        const double r = 0.1;
        assert_true(by_hand_rock(&rock, &random, 6 + n, r));
        chamfer_make(&c, &rock.core, r);
        check_closed(&c);
        solid_moments(&rock.core, &moments);
        assert_true(volume(&c) > moments.volume);
        for (int k = 0; k < c.corners; k++) /* on the rounded surface */
            assert_true(solid_depth(&rock.core, c.corner[k]) < -r + 1e-12 &&
                        solid_depth(&rock.core, c.corner[k]) > -r - 1e-12);
        chamfer_free(&c);
        solid_free(&rock.core);
    }
}

TEST_MAIN(chamfer, cmocka_unit_test(box), cmocka_unit_test(rocks))
