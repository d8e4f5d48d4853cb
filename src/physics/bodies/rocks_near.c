/* SPDX-License-Identifier: BSD-3-Clause */
/* From the features within the reach to points. Read rocks_near.h first. */
#include "physics/bodies/rocks_near.h"
#include "base/vector.h"
#include <math.h>
#include <string.h>

/* Edges that are more parallel than this factor says count by their ends (feature_edges). */
static const double crossing = 0.5;

/* Features of one point: their distance over the smaller rounding, and the cosine of 20 degrees between their normals. A feature is
 * deeper by this part of that distance. */
static const double merge_part = 0.01, alike = 0.94, deeper = 1e-3;

/* A place is the nearest one up to this part of the roundings. */
static const double same = 1e-6;

static double roundings_of(const struct rocks_pair *pair, const struct rocks_ends *ends) {
    return ends->posed[0].rounding + (pair->wall < 0 ? ends->posed[1].rounding : 0);
}

static double gap_of(const struct feature *feature) {
    return feature->overlap > 0 ? -feature->overlap / feature->weight : -feature->overlap;
}

/* True if no place of a core, which lies at `apart`, is nearer to `place` than `distance`, but for rounding. */
static bool is_nearest(const struct posed *posed, const double apart[3], const double place[3],
                       double distance) {
    const struct gjk_set point = {1, (const double(*)[3])place}, core = {posed->core->corners, posed->corner};
    struct gjk_simplex simplex = {0};
    struct gjk_nearest nearest;
    return gjk_distance(&point, &core, apart, &simplex, &nearest) && nearest.distance >= distance;
}

/* True if two edges are the places where both solids are nearest to each other, as seen from one of them. Of a wall only the
 * rock is asked. */
static bool edges_meet(const struct rocks_pair *pair, const struct rocks_ends *ends,
                       const struct feature *feature) {
    static const double here[3] = {0};
    double roundings = roundings_of(pair, ends), gap = gap_of(feature), distance = roundings + gap,
           least = distance - same * roundings, on_a[3], on_b[3];
    for (int d = 0; d < 3; d++) { /* feature_add has the middle of the overlap before the factor of edges */
        on_a[d] = feature->at[d] - (ends->posed[0].rounding + 0.5 * gap) * feature->normal[d];
        on_b[d] = on_a[d] + distance * feature->normal[d];
    }
    return (pair->wall < 0 && is_nearest(&ends->posed[1], ends->apart, on_a, least)) ||
           is_nearest(&ends->posed[0], here, on_b, least);
}

/* True if the point stands for a feature, or the feature for it. */
static bool is_alike(const struct rocks_point *point, const struct feature *feature, double merge) {
    double off[3];
    vector_minus(feature->at, point->at, off);
    return vector_dot(off, off) < merge * merge && vector_dot(feature->normal, point->normal) > alike;
}

/* The place of a feature among the points: that of one which is alike, a free one, or that of the farthest one. NULL: others stand
 * for it. */
static struct rocks_point *point_for(struct rocks_points *points, const struct feature *feature,
                                     double merge) {
    struct rocks_point *farthest = points->point;
    double gap = gap_of(feature);
    for (int k = 0; k < points->count; k++) {
        struct rocks_point *point = &points->point[k];
        if (is_alike(point, feature, merge))
            return gap < point->gap - deeper * merge ? point : NULL;
        farthest = point->gap > farthest->gap ? point : farthest;
    }
    if (points->count < ROCKS_POINTS_MAX)
        return &points->point[points->count++];
    return gap < farthest->gap ? farthest : NULL;
}

int rocks_near(const struct rocks_scene *scene, struct rocks_pair *pair, struct walls_probe *probe,
               struct rocks_ends *ends, struct rocks_points *points) {
    struct features features;
    points->count = 0;
    *ends = (struct rocks_ends){0};
    if (!rocks_ends_make(scene, pair, ends) || rocks_features(scene, pair, ends, probe, &features) == 0)
        return 0;
    double smaller =
        pair->wall < 0 ? fmin(ends->posed[0].rounding, ends->posed[1].rounding) : ends->posed[0].rounding;
    points->follow = TOUCH_MERGE * smaller;
    for (int k = 0; k < features.count; k++) {
        const struct feature *feature = &features.feature[k];
        bool edges = feature->key >> 16 == TOUCH_EDGES;
        if (feature->weight < crossing || (edges && !edges_meet(pair, ends, feature)))
            continue;
        struct rocks_point *point = point_for(points, feature, merge_part * smaller);
        if (point == NULL)
            continue;
        *point = (struct rocks_point){.gap = gap_of(feature), .key = feature->key};
        memcpy(point->at, feature->at, sizeof point->at);
        memcpy(point->normal, feature->normal, sizeof point->normal);
    }
    return points->count;
}
