/* SPDX-License-Identifier: BSD-3-Clause */
/* Convex solids against closed forms: faces, moments, cores, and points that are no solid. */
#include "tests/test.h"

#include "tests/near.h"
#include "tests/physics/bodies/shapes/solid_by_hand.h"

static void check_topology(const struct solid *solid) {
    assert_int_equal(solid->corners - solid->edges + solid->faces, 2);
    for (int f = 0; f < solid->faces; f++)
        for (int k = 0; k < solid->face[f].sides; k++) { /* counter-clockwise, seen from outside */
            const struct solid_face *face = &solid->face[f];
            const int *ring = solid->ring + face->first;
            const double *a = solid->corner[ring[k]], *b = solid->corner[ring[(k + 1) % face->sides]],
                         *c = solid->corner[ring[(k + 2) % face->sides]];
            double u[3], v[3], turn = 0;
            for (int d = 0; d < 3; d++) {
                u[d] = b[d] - a[d];
                v[d] = c[d] - b[d];
            }
            for (int d = 0; d < 3; d++)
                turn += face->normal[d] * (u[(d + 1) % 3] * v[(d + 2) % 3] - u[(d + 2) % 3] * v[(d + 1) % 3]);
            assert_true(turn > 0);
            const struct solid_edge *edge = &solid->edge[solid->rim[face->first + k]];
            assert_true(edge->face[0] == f || edge->face[1] == f);
        }
    for (int e = 0; e < solid->edges; e++)
        assert_true(solid->edge[e].face[0] >= 0 && solid->edge[e].face[1] >= 0);
}

/* A box with points in its faces, edges and middle: six faces, and the moments of a box. */
static void box(void **state) {
    double point[27][3];
    struct solid solid, core;
    struct moments moments;
    struct error error = {0};
    (void)state;
    for (int k = 0; k < 27; k++) {
        point[k][0] = 3 + 2 * (k % 3);
        point[k][1] = 1.5 * (k / 3 % 3);
        point[k][2] = 1.0 * (k / 9);
    }
    assert_true(solid_make(&solid, (const double(*)[3])point, 27, &error));
    assert_int_equal(solid.corners, 8);
    assert_int_equal(solid.faces, 6);
    assert_int_equal(solid.edges, 12);
    check_topology(&solid);
    solid_moments(&solid, &moments);
    assert_near(moments.volume, 4 * 3 * 2, 1e-12);
    assert_near(moments.centre[0], 5, 1e-13);
    assert_near(moments.gyration[0], (9 + 4) / 12.0, 1e-12);
    assert_near(moments.gyration[8], (16 + 9) / 12.0, 1e-12);
    assert_near(moments.gyration[1], 0, 1e-12);
    assert_true(solid_inset(&core, &solid, 0.25, &error));
    check_topology(&core);
    solid_moments(&core, &moments);
    assert_near(moments.volume, 3.5 * 2.5 * 1.5, 1e-12);
    solid_free(&core);
    assert_false(solid_inset(&core, &solid, 1.0, &error));
    assert_non_null(strstr(error.text, "leaves no core"));
    solid_free(&core);
    solid_free(&solid);
}

/* A regular octahedron, four faces at each corner: volume sqrt(2)/3 a^3, inertia m a^2 / 10; its core is one, too. */
static void octahedron(void **state) {
    double point[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    struct solid solid, core;
    struct moments moments;
    struct error error = {0};
    (void)state;
    assert_true(solid_make(&solid, (const double(*)[3])point, 6, &error));
    assert_int_equal(solid.faces, 8);
    check_topology(&solid);
    solid_moments(&solid, &moments);
    assert_near(moments.volume, 4.0 / 3, 1e-13);
    for (int d = 0; d < 3; d++)
        assert_near(moments.gyration[4 * d], 2.0 / 10, 1e-13);
    assert_true(solid_inset(&core, &solid, 0.1, &error));
    assert_int_equal(core.corners, 6);
    assert_near(solid_extent(&core), 1 - 0.1 * sqrt(3), 1e-12);
    solid_free(&core);
    solid_free(&solid);
}

/* Moments of random rocks against a sum over a fine grid of places, to its error. */
static void rocks(void **state) {
    struct random_sequence random = random_sequence(1, RANDOM_TEST, 0);
    (void)state;
    for (int n = 0; n < 30; n++) {
        struct by_hand rock, core;
        struct moments moments;
        struct error error = {0};
        assert_true(by_hand_rock(&rock, &random, 8 + n, 0.1));
        check_topology(&rock.core);
        solid_moments(&rock.core, &moments);
        double volume = 0, first = 0, step = 0.05;
        for (double x = -0.975; x < 1; x += step)
            for (double y = -0.975; y < 1; y += step)
                for (double z = -0.975; z < 1; z += step)
                    if (solid_depth(&rock.core, (double[3]){x, y, z}) > 0) {
                        volume += step * step * step;
                        first += step * step * step * x;
                    }
        assert_near(volume, moments.volume, 0.02 * moments.volume);
        assert_near(first / volume, moments.centre[0], 0.01);
        if (solid_inset(&core.core, &rock.core, 0.02, &error)) {
            check_topology(&core.core);
            assert_true(core.core.faces <= rock.core.faces);
            for (int k = 0; k < core.core.corners; k++)
                assert_near(solid_depth(&rock.core, core.core.corner[k]), 0.02, 1e-8);
        }
        solid_free(&core.core);
        solid_free(&rock.core);
    }
}

static void check_refused(const double (*point)[3], size_t points, const char *why) {
    struct solid solid;
    struct error error = {0};
    assert_false(solid_make(&solid, point, points, &error));
    if (strstr(error.text, why) == NULL)
        fail_msg("%s, not: %s", error.text, why);
    solid_free(&solid);
}

static void refusals(void **state) {
    double square[5][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
    double sliver[5][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 5e-4}};
    double many[200][3];
    (void)state;
    check_refused((const double(*)[3])square, 5, "no volume");
    check_refused((const double(*)[3])square, 3, "no volume");
    check_refused((const double(*)[3])sliver, 5, "sliver");
    for (int k = 0; k < 200; k++) {
        many[k][2] = (k - 99.5) / 100;
        many[k][0] = sqrt(1 - many[k][2] * many[k][2]) * cos(2.4 * k);
        many[k][1] = sqrt(1 - many[k][2] * many[k][2]) * sin(2.4 * k);
    }
    check_refused((const double(*)[3])many, 200, "at most 64");
}

TEST_MAIN(solid, cmocka_unit_test(box), cmocka_unit_test(octahedron), cmocka_unit_test(rocks),
          cmocka_unit_test(refusals))
