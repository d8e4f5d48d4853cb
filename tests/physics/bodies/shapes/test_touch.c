/* SPDX-License-Identifier: BSD-3-Clause */
/* Contacts of solids: distances against brute force over all features, depths against all directions and libccd (if it is there),
 * the force as the slope of an energy, and the points of faces. */
#include "tests/test.h"

#include "config.h"
#include "physics/bodies/shapes/deep.h"
#include "physics/bodies/shapes/touch.h"
#include "tests/near.h"
#include "tests/physics/bodies/shapes/solid_by_hand.h"
#include <stdio.h>
#include <stdlib.h>
#ifdef HAVE_CCD
#include <ccd/ccd.h>
#endif

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double clamp(double x) {
    return x < 0 ? 0 : x > 1 ? 1 : x;
}

/* Distance of two segments: the least over the inner points, if any, and over each end. */
static double segments_apart(const double a[3], const double b[3], const double c[3], const double e[3]) {
    double u[3], v[3], w[3], best = INFINITY;
    for (int d = 0; d < 3; d++) {
        u[d] = b[d] - a[d];
        v[d] = e[d] - c[d];
        w[d] = c[d] - a[d];
    }
    double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w),
           det = uu * vv - uv * uv;
    double s = det > 0 ? (uw * vv - vw * uv) / det : 0, t = det > 0 ? (uw * uv - vw * uu) / det : 0;
    const double pair[5][2] = {{s, t},
                               {0, clamp(-vw / vv)},
                               {1, clamp((uv - vw) / vv)},
                               {clamp(uw / uu), 0},
                               {clamp((uw + uv) / uu), 1}};
    for (int k = 0; k < 5; k++) {
        double square = 0;
        if (pair[k][0] < 0 || pair[k][0] > 1 || pair[k][1] < 0 || pair[k][1] > 1)
            continue;
        for (int d = 0; d < 3; d++) {
            double way = w[d] + pair[k][1] * v[d] - pair[k][0] * u[d];
            square += way * way;
        }
        best = fmin(best, square);
    }
    return sqrt(best);
}

/* Distance of a place from a face, where its foot is inside. */
static double face_apart(const struct posed *posed, int f, const double place[3]) {
    const struct solid_face *face = &posed->core->face[f];
    double normal[3];
    posed_normal(posed, f, normal);
    for (int k = 0; k < face->sides; k++) {
        const double *a = posed->corner[posed->core->ring[face->first + k]],
                     *b = posed->corner[posed->core->ring[face->first + (k + 1) % face->sides]];
        double inward = 0;
        for (int d = 0; d < 3; d++) {
            int e = (d + 1) % 3, g = (d + 2) % 3;
            inward += (normal[e] * (b[g] - a[g]) - normal[g] * (b[e] - a[e])) * (place[d] - a[d]);
        }
        if (inward < 0)
            return INFINITY;
    }
    return fabs(dot(normal, place) - posed->scale * face->offset);
}

/* The distance of solids that do not overlap, over all pairs of features. */
static double brute_apart(const struct posed *a, const struct posed *b, const double apart[3]) {
    double best = INFINITY;
    for (int k = 0; k < b->core->corners; k++)
        for (int f = 0; f < a->core->faces; f++) {
            double x[3];
            for (int d = 0; d < 3; d++)
                x[d] = b->corner[k][d] + apart[d];
            best = fmin(best, face_apart(a, f, x));
        }
    for (int k = 0; k < a->core->corners; k++)
        for (int f = 0; f < b->core->faces; f++) {
            double x[3];
            for (int d = 0; d < 3; d++)
                x[d] = a->corner[k][d] - apart[d];
            best = fmin(best, face_apart(b, f, x));
        }
    for (int i = 0; i < a->core->edges; i++)
        for (int j = 0; j < b->core->edges; j++) {
            double end[2][3];
            for (int c = 0; c < 2; c++)
                for (int d = 0; d < 3; d++)
                    end[c][d] = b->corner[b->core->edge[j].end[c]][d] + apart[d];
            best = fmin(best, segments_apart(a->corner[a->core->edge[i].end[0]],
                                             a->corner[a->core->edge[i].end[1]], end[0], end[1]));
        }
    return best;
}

static void draw_apart(struct random_sequence *random, double length, double apart[3]) {
    double norm = 0;
    for (int d = 0; d < 3; d++) {
        apart[d] = random_normal(random);
        norm += apart[d] * apart[d];
    }
    for (int d = 0; d < 3; d++)
        apart[d] *= length / sqrt(norm);
}

/* Pairs of rocks: the distance, cold, warm and with both exchanged; where they overlap, no direction parts them sooner. */
static void distances(void **state) {
    struct random_sequence random = random_sequence(2, RANDOM_TEST, 0);
    int parted = 0, rounds = 0, warm_rounds = 0;
    (void)state;
    for (int n = 0; n < 400; n++) {
        struct by_hand a, b;
        assert_true(by_hand_rock(&a, &random, 6 + n % 20, 0.1));
        assert_true(by_hand_rock(&b, &random, 6 + n % 13, 0.1));
        struct gjk_set set_a = {a.core.corners, a.posed.corner}, set_b = {b.core.corners, b.posed.corner};
        for (int m = 0; m < 10; m++) {
            double apart[3], back[3], normal[3];
            struct gjk_simplex simplex = {0}, other = {0};
            struct gjk_nearest nearest, warm;
            draw_apart(&random, 1.2 + 0.1 * m, apart);
            double depth = deep_overlap(&a.posed, &b.posed, apart, normal);
            bool free = gjk_distance(&set_a, &set_b, apart, &simplex, &nearest);
            assert_true(free == (depth < -1e-6 * 2) || fabs(depth) < 1e-5);
            if (!free)
                continue;
            double exact = brute_apart(&a.posed, &b.posed, apart);
            assert_near(nearest.distance, exact, 1e-13 + 1e-10 * exact);
            assert_near(dot(nearest.normal, nearest.normal), 1, 1e-14);
            for (int d = 0; d < 3; d++) {
                assert_near(nearest.on_b[d] - nearest.on_a[d], nearest.distance * nearest.normal[d], 1e-12);
                back[d] = -apart[d];
            }
            parted++;
            rounds += nearest.rounds;
            assert_true(gjk_distance(&set_a, &set_b, apart, &simplex, &warm));
            assert_near(warm.distance, nearest.distance, 1e-14);
            warm_rounds += warm.rounds;
            assert_true(gjk_distance(&set_b, &set_a, back, &other, &warm));
            assert_near(warm.distance, nearest.distance, 1e-12);
        }
        solid_free(&a.core);
        solid_free(&b.core);
    }
    print_message("%d pairs apart, %.2f rounds cold, %.2f warm\n", parted, (double)rounds / parted,
                  (double)warm_rounds / parted);
    assert_true(parted > 1000 && warm_rounds < 1.2 * parted);
}

/* No direction has less overlap, and a move by the depth parts the solids. */
static void depths(void **state) {
    struct random_sequence random = random_sequence(3, RANDOM_TEST, 0);
    (void)state;
    for (int n = 0; n < 100; n++) {
        struct by_hand a, b;
        double apart[3], normal[3], axis[3];
        assert_true(by_hand_rock(&a, &random, 6 + n % 20, 0.1));
        assert_true(by_hand_rock(&b, &random, 6 + n % 13, 0.1));
        draw_apart(&random, 0.4 + 0.006 * n, apart);
        double depth = deep_overlap(&a.posed, &b.posed, apart, normal);
        for (int m = 0; m < 1000; m++) {
            double most = -INFINITY, least = INFINITY;
            draw_apart(&random, 1, axis);
            for (int k = 0; k < a.core.corners; k++)
                most = fmax(most, dot(a.corner[k], axis));
            for (int k = 0; k < b.core.corners; k++)
                least = fmin(least, dot(b.corner[k], axis) + dot(apart, axis));
            assert_true(most - least >= depth - 1e-12);
        }
        if (depth > 1e-3) {
            struct gjk_set set_a = {a.core.corners, a.posed.corner}, set_b = {b.core.corners, b.posed.corner};
            struct gjk_simplex simplex = {0};
            struct gjk_nearest nearest;
            for (int d = 0; d < 3; d++)
                apart[d] += (depth + 1e-4) * normal[d];
            assert_true(gjk_distance(&set_a, &set_b, apart, &simplex, &nearest));
            assert_near(nearest.distance, 1e-4, 1e-11);
        }
        solid_free(&a.core);
        solid_free(&b.core);
    }
}

#ifdef HAVE_CCD
struct ccd_rock {
    const struct by_hand *rock;
    const double *apart;
};

static void ccd_support(const void *object, const ccd_vec3_t *direction, ccd_vec3_t *place) {
    const struct ccd_rock *ccd = object;
    int best = 0;
    for (int k = 1; k < ccd->rock->core.corners; k++)
        best =
            dot(ccd->rock->corner[k], direction->v) > dot(ccd->rock->corner[best], direction->v) ? k : best;
    for (int d = 0; d < 3; d++)
        place->v[d] = ccd->rock->corner[best][d] + ccd->apart[d];
}

/* Of SCREE_PAIRS pairs, 20,000 where that is not set, both say alike whether they overlap, and how deep, but for those that touch to the
 * tolerance of libccd. */
static void against_ccd(void **state) {
    static const double none[3] = {0};
    const char *asked = getenv("SCREE_PAIRS");
    const long pairs = asked ? atol(asked) : 20000;
    struct random_sequence random = random_sequence(4, RANDOM_TEST, 0);
    long unlike = 0, deep = 0, off = 0;
    ccd_t ccd;
    (void)state;
    CCD_INIT(&ccd);
    ccd.support1 = ccd.support2 = ccd_support;
    ccd.max_iterations = 200;
    ccd.epa_tolerance = 1e-7;
    for (int n = 0; n < pairs / 100; n++) {
        struct by_hand a, b;
        assert_true(by_hand_rock(&a, &random, 6 + n % 20, 0.1));
        assert_true(by_hand_rock(&b, &random, 6 + n % 13, 0.1));
        for (int m = 0; m < 100; m++) {
            double apart[3], normal[3], q[4];
            draw_apart(&random, 0.6 + 0.012 * m, apart);
            by_hand_draw_turn(&random, q);
            by_hand_pose(&b, q, 0.1);
            struct ccd_rock one = {&a, none}, other = {&b, apart};
            double depth = deep_overlap(&a.posed, &b.posed, apart, normal);
            unlike += ccdGJKIntersect(&one, &other, &ccd) != (depth > 0) && fabs(depth) > 1e-6;
            if (depth > 1e-3 && m % 10 == 0) {
                ccd_real_t theirs = 0;
                ccd_vec3_t direction, place;
                deep++;
                if (ccdGJKPenetration(&one, &other, &ccd, &theirs, &direction, &place) != 0 ||
                    fabs(theirs - depth) > 1e-5)
                    off++;
            }
        }
        solid_free(&a.core);
        solid_free(&b.core);
    }
    print_message("libccd: %ld of %ld pairs unlike, %ld of %ld depths unlike\n", unlike, pairs / 100 * 100,
                  off, deep);
    assert_int_equal(unlike, 0);
    assert_true(off <= deep / 100); /* its polytope ends early now and then */
}
#else
static void against_ccd(void **state) {
    (void)state;
    print_message("skipped on 1 ranks: no libccd when configure ran (Debian: libccd-dev)\n");
    skip();
}
#endif

/* The overlap after small moves and turns of B changes as push and turns say: rocks that meet in any way, and cubes whose
 * faces are parallel to some degrees or less. */
static void check_slope(struct by_hand *a, struct by_hand *b, const double q[4], const double apart[3],
                        struct random_sequence *random, double worst[2]) {
    const double small = 1e-7;
    double way[3], spin[3], slope = 0, value[2], back[3];
    struct gjk_simplex simplex = {0};
    struct touch touch, moved;
    if (!by_hand_touch(&a->posed, &b->posed, apart, &simplex, &touch))
        return;
    draw_apart(random, 1, way);
    draw_apart(random, 1, spin);
    for (int d = 0; d < 3; d++)
        slope -= touch.push[d] * way[d] + touch.turn[1][d] * spin[d];
    for (int side = 0; side < 2; side++) {
        double sign = side ? 1 : -1, turned[4], there[3];
        memcpy(turned, q, sizeof turned);
        rotor_spin(turned, spin, sign * small);
        by_hand_pose(b, turned, b->posed.rounding);
        for (int d = 0; d < 3; d++)
            there[d] = apart[d] + sign * small * way[d];
        value[side] = by_hand_touch(&a->posed, &b->posed, there, &simplex, &moved) ? moved.overlap : 0;
    }
    worst[0] = fmax(worst[0], fabs((value[1] - value[0]) / (2 * small) - slope));
    worst[1]++;
    for (int d = 0; d < 3; d++) { /* no torque on both together */
        int e = (d + 1) % 3, f = (d + 2) % 3;
        back[d] = touch.turn[0][d] + touch.turn[1][d] + apart[e] * touch.push[f] - apart[f] * touch.push[e];
        assert_near(back[d], 0, 1e-9);
    }
}

static void slopes(void **state) {
    struct random_sequence random = random_sequence(5, RANDOM_TEST, 0);
    double worst[2] = {0}, tilted[2] = {0};
    struct by_hand a, b;
    (void)state;
    for (int n = 0; n < 1000; n++) {
        double apart[3], q[4];
        assert_true(by_hand_rock(&a, &random, 8, 0.2));
        assert_true(by_hand_rock(&b, &random, 8, 0.15));
        by_hand_draw_turn(&random, q);
        by_hand_pose(&b, q, 0.15);
        draw_apart(&random, 1.5, apart);
        check_slope(&a, &b, q, apart, &random, worst);
        solid_free(&a.core);
        solid_free(&b.core);
    }
    assert_true(by_hand_box(&a, 1, 1, 1, 0.05) && by_hand_box(&b, 0.9, 1.1, 1, 0.05));
    for (int n = 0; n < 1000; n++) {
        double apart[3], q[4] = {1, 0, 0, 0}, axis[3];
        rotor_spin(q, (double[3]){0, 0, 1}, 6 * random_uniform(&random));
        draw_apart(&random, 1, axis);
        rotor_spin(q, axis, 0.05 * random_uniform(&random));
        by_hand_pose(&b, q, 0.05);
        for (int d = 0; d < 2; d++)
            apart[d] = 1.2 * (random_uniform(&random) - 0.5);
        apart[2] = 1.09;
        check_slope(&a, &b, q, apart, &random, tilted);
    }
    print_message("largest error of a slope: %.2g in %g contacts of rocks, %.2g in %g of faces\n", worst[0],
                  worst[1], tilted[0], tilted[1]);
    assert_true(worst[1] > 100 && worst[0] < 1e-4 && tilted[1] > 500 && tilted[0] < 1e-4);
    solid_free(&a.core);
    solid_free(&b.core);
}

/* Cubes on each other, straight, moved, and turned by 45 degrees; an edge and a corner on a face. */
static void faces(void **state) {
    static const struct {
        double turn, x, tilt;
        int points;
    } row[] = {{0, 0, 0, 4}, {0, 0.3, 0, 4}, {M_PI / 4, 0, 0, 8}, {0.3, 0.1, 0, -1}, {0, 0, M_PI / 4, 2}};
    struct by_hand a, b;
    (void)state;
    assert_true(by_hand_box(&a, 1, 1, 1, 0.05));
    assert_true(by_hand_box(&b, 1, 1, 1, 0.05));
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        double apart[3] = {row[k].x, 0, 1.09}, sum = 0, middle[3] = {0}, q[4] = {1, 0, 0, 0};
        struct gjk_simplex simplex = {0};
        struct touch touch;
        rotor_spin(q, (double[3]){0, 0, 1}, row[k].turn);
        rotor_spin(q, (double[3]){1, 0, 0}, row[k].tilt);
        by_hand_pose(&b, q, 0.05);
        apart[2] += row[k].tilt > 0 ? sqrt(0.5) - 0.5 : 0;
        assert_true(by_hand_touch(&a.posed, &b.posed, apart, &simplex, &touch));
        assert_true(touch.push[2] > 0.9 && fabs(touch.push[0]) < 0.1 * touch.push[2]);
        assert_true(touch.overlap >= 0.01 && touch.overlap < 0.02); /* 64 features at most */
        assert_true(touch.points == row[k].points || row[k].points < 0);
        for (int p = 0; p < touch.points; p++) {
            assert_near(touch.point[p].at[2], 0.5 + 0.045, 1e-9);
            sum += touch.point[p].share;
            for (int d = 0; d < 3; d++)
                middle[d] += touch.point[p].share * touch.point[p].at[d];
            for (int o = 0; o < p; o++)
                assert_true(touch.point[o].key != touch.point[p].key);
        }
        for (int d = 0; d < 3; d++)
            middle[d] /= sum;
        assert_near(touch.push[2], sum, 0.01);
        assert_true(row[k].points < 0 || fabs(middle[0] - 0.5 * row[k].x) < 1e-9);
    }
    by_hand_pose(&b, (double[4]){1, 0, 0, 0}, 0.05);
    struct touch touch;
    struct gjk_simplex simplex = {0};
    assert_true(
        by_hand_touch(&a.posed, &b.posed, (double[3]){0, 0.2, 0.9}, &simplex, &touch)); /* cores overlap */
    assert_near(touch.overlap, 0.2, 1e-12);
    assert_int_equal(touch.points, 1);
    assert_false(by_hand_touch(&a.posed, &b.posed, (double[3]){0, 0.2, 1.101}, &simplex, &touch));
    solid_free(&a.core);
    solid_free(&b.core);
}

/* A sphere on a face, an edge and a corner of a cube, and deep inside. */
static void spheres(void **state) {
    static const struct {
        double apart[3], overlap;
    } row[] = {{{0.1, 0.2, 0.79}, 0.06},
               {{0, 0.74, 0.68}, 0.05},
               {{0.6, 0.6, 0.6}, 0.35 - 0.17320508075688776},
               {{0, 0.1, 0.4}, 0.45}};
    struct by_hand cube, sphere;
    (void)state;
    assert_true(by_hand_box(&cube, 1, 1, 1, 0.05));
    solid_dot(&sphere.core);
    by_hand_pose(&sphere, (double[4]){1, 0, 0, 0}, 0.3);
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++)
        for (int side = 0; side < 2; side++) {
            struct gjk_simplex simplex = {0};
            struct touch touch;
            double apart[3];
            for (int d = 0; d < 3; d++)
                apart[d] = side ? -row[k].apart[d] : row[k].apart[d];
            assert_true(by_hand_touch(side ? &sphere.posed : &cube.posed, side ? &cube.posed : &sphere.posed,
                                      apart, &simplex, &touch));
            assert_int_equal(touch.points, 1);
            assert_near(touch.overlap, row[k].overlap, 1e-12);
            assert_near(touch.point[0].share, 1, 0);
        }
    solid_free(&cube.core);
    solid_free(&sphere.core);
}

/* Within a reach the features are those of solids whose roundings are larger by half of it, with gaps of their own. */
static void gaps(void **state) {
    (void)state;
    struct random_sequence random = random_sequence(7, RANDOM_SHAPE, 0);
    const double rounding = 0.1, reach = 0.06;
    int open = 0;
    for (int n = 0; n < 600; n++) {
        struct by_hand a, b;
        struct gjk_simplex simplex = {0}, again = {0};
        struct features thin = {.reach = reach}, fat;
        double apart[3] = {0, 0, 1.7 + 0.5 * random_uniform(&random)}, normal[3];
        assert_true(by_hand_rock(&a, &random, 9, rounding) && by_hand_rock(&b, &random, 9, rounding));
        struct posed more[2] = {a.posed, b.posed};
        for (int k = 0; k < 2; k++)
            more[k].rounding += 0.5 * reach;
        bool near = touch_near(&a.posed, &b.posed, apart, &simplex, &thin, normal);
        assert_int_equal(near, touch_find(&more[0], &more[1], apart, &again, &fat, normal));
        for (int k = 0; near && k < thin.count; k++) {
            const struct feature *one = &thin.feature[k], *other = &fat.feature[k];
            assert_int_equal(thin.count, fat.count);
            assert_int_equal(one->key, other->key);
            open += one->overlap < 0;
            if (other->weight < 1) /* an overlap has the factor of edges, a gap has not */
                continue;
            assert_near(one->overlap + reach, other->overlap, 1e-9);
            for (int d = 0; d < 3; d++) {
                assert_near(one->at[d], other->at[d], 1e-6);
                assert_near(one->normal[d], other->normal[d], 1e-6);
            }
        }
        solid_free(&a.core);
        solid_free(&b.core);
    }
    assert_true(open > 20);
}

/* A face above a face: four corners with the gap between the faces, and a plane below. */
static void open_faces(void **state) {
    (void)state;
    struct by_hand a, b;
    struct gjk_simplex simplex = {0};
    struct features features = {.reach = 0.02};
    double normal[3];
    const double apart[3] = {0.02, 0.01, 1.2 + 0.015};
    assert_true(by_hand_box(&a, 1, 1, 1, 0.1) && by_hand_box(&b, 0.5, 0.5, 1, 0.1));
    assert_true(touch_near(&a.posed, &b.posed, apart, &simplex, &features, normal));
    assert_int_equal(features.count, 4);
    for (int k = 0; k < 4; k++) {
        assert_int_equal(features.feature[k].key >> 16, TOUCH_CORNER_B);
        assert_near(features.feature[k].overlap, -0.015, 1e-12);
        assert_near(features.feature[k].at[2], 0.6 + 0.0075, 1e-12);
    }
    features.reach = 0.01;
    assert_false(touch_near(&a.posed, &b.posed, apart, &simplex, &features, normal));
    solid_free(&a.core);
    solid_free(&b.core);
}

TEST_MAIN(touch, cmocka_unit_test(distances), cmocka_unit_test(depths), cmocka_unit_test(against_ccd),
          cmocka_unit_test(slopes), cmocka_unit_test(faces), cmocka_unit_test(spheres),
          cmocka_unit_test(gaps), cmocka_unit_test(open_faces))
