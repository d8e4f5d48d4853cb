/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds the features of two solids that touch. Read touch.h first. */
#include "physics/bodies/shapes/touch.h"
#include "base/vector.h"
#include "physics/bodies/shapes/deep.h"
#include "physics/bodies/shapes/feature.h"
#include <math.h>
#include <string.h>

/* Both solids, the nearest points of their cores, and how far features may lie below these to count. */
struct pair {
    const struct posed *a, *b;
    const double *apart, *normal;
    double roundings, slack, top_a, top_b; /* tops along the normal, of B against it */
};

static double top_of(const struct posed *posed, const double normal[3], double sign) {
    double most = -INFINITY;
    for (int k = 0; k < posed->core->corners; k++)
        most = fmax(most, sign * vector_dot(posed->corner[k], normal));
    return most;
}

/* True if a corner may be nearer to the other core than the roundings: no place of that core is nearer than its plane. */
static bool is_near(const struct pair *pair, int side, int corner) {
    const struct posed *posed = side ? pair->b : pair->a;
    double height = vector_dot(posed->corner[corner], pair->normal);
    return (side ? pair->top_b + height : pair->top_a - height) < pair->slack;
}

/* Corners of one solid above the other one. */
static void corners_take(struct features *features, const struct pair *pair, int side) {
    const struct posed *own = side ? pair->b : pair->a;
    for (int k = 0; k < own->core->corners; k++) {
        struct gjk_set set_a = {pair->a->core->corners, pair->a->corner},
                       set_b = {pair->b->core->corners, pair->b->corner};
        struct gjk_set *set = side ? &set_b : &set_a;
        struct gjk_simplex simplex = {0};
        struct gjk_nearest nearest;
        if (!is_near(pair, side, k))
            continue;
        *set = (struct gjk_set){1, &own->corner[k]};
        if (gjk_distance(&set_a, &set_b, pair->apart, &simplex, &nearest))
            feature_add(features, pair->a, pair->roundings, nearest.distance, nearest.on_a, nearest.normal,
                        touch_key(side ? TOUCH_CORNER_B : TOUCH_CORNER_A, k, 0));
    }
}

/* The edges of a solid with an end that is near; returns their number. */
static int edges_near(const struct pair *pair, int side, int edge[SOLID_EDGES_MAX]) {
    const struct solid *core = side ? pair->b->core : pair->a->core;
    int count = 0;
    for (int e = 0; e < core->edges; e++)
        if (is_near(pair, side, core->edge[e].end[0]) || is_near(pair, side, core->edge[e].end[1]))
            edge[count++] = e;
    return count;
}

static void edges_take(struct features *features, const struct pair *pair) {
    int edge_a[SOLID_EDGES_MAX], edge_b[SOLID_EDGES_MAX];
    int count_a = edges_near(pair, 0, edge_a), count_b = edges_near(pair, 1, edge_b);
    for (int j = 0; j < count_b; j++) {
        double place[2][3];
        for (int c = 0; c < 2; c++)
            for (int d = 0; d < 3; d++)
                place[c][d] = pair->b->corner[pair->b->core->edge[edge_b[j]].end[c]][d] + pair->apart[d];
        for (int i = 0; i < count_a; i++) {
            const int *end_a = pair->a->core->edge[edge_a[i]].end;
            const double *const end[4] = {pair->a->corner[end_a[0]], pair->a->corner[end_a[1]], place[0],
                                          place[1]};
            feature_edges(features, pair->a, pair->roundings, end,
                          touch_key(TOUCH_EDGES, edge_a[i], edge_b[j]));
        }
    }
}

/* The one feature of cores that overlap: their nearest points after a move that parts them. False: they do not touch. */
static void deep_take(struct features *features, const struct pair *pair, double normal[3]) {
    const struct posed *a = pair->a, *b = pair->b;
    const struct gjk_set set_a = {a->core->corners, a->corner}, set_b = {b->core->corners, b->corner};
    const double depth = deep_overlap(a, b, pair->apart, normal);
    struct gjk_simplex simplex = {0};
    struct gjk_nearest nearest = {0};
    double moved[3];
    for (int d = 0; d < 3; d++)
        moved[d] = pair->apart[d] + (depth + pair->roundings) * normal[d];
    gjk_distance(&set_a, &set_b, moved, &simplex, &nearest);
    feature_add(features, a, pair->roundings, -depth, nearest.on_a, normal, touch_key(TOUCH_DEEP, 0, 0));
}

bool touch_near(const struct posed *a, const struct posed *b, const double apart[3],
                struct gjk_simplex *simplex, struct features *features, double normal[3]) {
    const struct gjk_set set_a = {a->core->corners, a->corner}, set_b = {b->core->corners, b->corner};
    struct pair pair = {
        .a = a, .b = b, .apart = apart, .normal = normal, .roundings = a->rounding + b->rounding};
    struct gjk_nearest nearest;
    features->count = 0;
    if (!gjk_distance(&set_a, &set_b, apart, simplex, &nearest)) {
        deep_take(features, &pair, normal);
        return features->count > 0;
    }
    if (!(nearest.distance < pair.roundings + features->reach))
        return false;
    memcpy(normal, nearest.normal, sizeof nearest.normal);
    pair.slack = pair.roundings + features->reach - nearest.distance;
    pair.top_a = top_of(a, normal, 1);
    pair.top_b = top_of(b, normal, -1);
    if (b->core->corners > 1) /* the middle of a sphere is the only feature of its contact */
        corners_take(features, &pair, 0);
    if (a->core->corners > 1 || b->core->corners == 1)
        corners_take(features, &pair, 1);
    edges_take(features, &pair);
    return features->count > 0;
}

bool touch_find(const struct posed *a, const struct posed *b, const double apart[3],
                struct gjk_simplex *simplex, struct features *features, double normal[3]) {
    features->reach = 0;
    return touch_near(a, b, apart, simplex, features, normal);
}

bool touch_plane(const struct posed *a, const double inward[3], double height, struct features *features) {
    double normal[3];
    features->count = 0;
    features->reach = 0;
    for (int d = 0; d < 3; d++)
        normal[d] = -inward[d];
    for (int k = 0; k < a->core->corners; k++)
        feature_add(features, a, a->rounding, height + vector_dot(inward, a->corner[k]), a->corner[k], normal,
                    touch_key(TOUCH_CORNER_A, k, 0));
    return features->count > 0;
}
