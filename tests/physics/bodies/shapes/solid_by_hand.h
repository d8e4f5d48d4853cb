/* SPDX-License-Identifier: BSD-3-Clause */
/* Solids for tests: boxes, and random rocks, as they stand in space. */
#ifndef SCREE_TESTS_SOLID_BY_HAND_H
#define SCREE_TESTS_SOLID_BY_HAND_H

#include "base/random.h"
#include "base/rotor.h"
#include "physics/bodies/shapes/touch.h"
#include <math.h>
#include <string.h>

/* A solid with its pose. */
struct by_hand {
    struct solid core;
    double corner[SOLID_CORNERS_MAX][3], turn[9];
    struct posed posed;
};

static inline void by_hand_pose(struct by_hand *rock, const double q[4], double rounding) {
    rotor_matrix(q, rock->turn);
    posed_corners(&rock->core, rock->turn, 1, rock->corner);
    rock->posed = (struct posed){&rock->core, (const double(*)[3])rock->corner, rock->turn, 1, rounding};
}

/* A box about the origin. */
static inline bool by_hand_box(struct by_hand *rock, double a, double b, double c, double rounding) {
    double point[8][3];
    struct error error = {0};
    for (int k = 0; k < 8; k++) {
        point[k][0] = k & 1 ? 0.5 * a : -0.5 * a;
        point[k][1] = k & 2 ? 0.5 * b : -0.5 * b;
        point[k][2] = k & 4 ? 0.5 * c : -0.5 * c;
    }
    bool good = solid_make(&rock->core, (const double(*)[3])point, 8, &error);
    by_hand_pose(rock, (double[4]){1, 0, 0, 0}, rounding);
    return good;
}

static inline void by_hand_draw_turn(struct random_sequence *random, double q[4]) {
    double norm = 0;
    for (int k = 0; k < 4; k++) {
        q[k] = random_normal(random);
        norm += q[k] * q[k];
    }
    for (int k = 0; k < 4; k++)
        q[k] /= sqrt(norm);
}

/* Tries a random rock of the hull of points on an ellipsoid, with a random turn. */
static inline bool by_hand_try(struct by_hand *rock, struct random_sequence *random, int points,
                               double rounding) {
    double point[SOLID_CORNERS_MAX][3], q[4];
    struct error error = {0};
    for (int k = 0; k < points; k++) {
        double norm = 0;
        for (int d = 0; d < 3; d++) {
            point[k][d] = random_normal(random);
            norm += point[k][d] * point[k][d];
        }
        for (int d = 0; d < 3; d++)
            point[k][d] *= (1 - 0.2 * d) / sqrt(norm);
    }
    bool good = solid_make(&rock->core, (const double(*)[3])point, (size_t)points, &error);
    by_hand_draw_turn(random, q);
    by_hand_pose(rock, q, rounding);
    return good;
}

/* The first of such rocks that is no sliver. */
static inline bool by_hand_rock(struct by_hand *rock, struct random_sequence *random, int points,
                                double rounding) {
    for (int n = 0; n < 20; n++) {
        if (by_hand_try(rock, random, points, rounding))
            return true;
        solid_free(&rock->core);
    }
    return false;
}

/* The contact of two solids, its features added up; false: none. */
static inline bool by_hand_touch(const struct posed *a, const struct posed *b, const double apart[3],
                                 struct gjk_simplex *simplex, struct touch *touch) {
    struct features features;
    double normal[3];
    *touch = (struct touch){0};
    if (!touch_find(a, b, apart, simplex, &features, normal))
        return false;
    feature_sum(features.feature, features.count, apart, TOUCH_MERGE * fmin(a->rounding, b->rounding), touch);
    return true;
}

#endif
