/* SPDX-License-Identifier: BSD-3-Clause */
/* Adds up the features of a contact. Read touch.h first. */
#include "physics/bodies/shapes/feature.h"
#include "base/vector.h"
#include <math.h>
#include <string.h>

static void cross(const double a[3], const double b[3], double c[3]) {
    for (int d = 0; d < 3; d++) {
        int e = (d + 1) % 3, f = (d + 2) % 3;
        c[d] = a[e] * b[f] - a[f] * b[e];
    }
}

struct feature *feature_add(struct features *features, const struct posed *a, double roundings,
                            double distance, const double on_a[3], const double normal[3], uint32_t key) {
    if (!(distance < roundings + features->reach) || features->count == FEATURES_MAX)
        return NULL;
    struct feature *feature = &features->feature[features->count++];
    *feature = (struct feature){.overlap = roundings - distance, .weight = 1, .key = key};
    memcpy(feature->normal, normal, sizeof feature->normal);
    for (int d = 0; d < 3; d++)
        feature->at[d] = on_a[d] + (a->rounding - 0.5 * feature->overlap) * normal[d];
    return feature;
}

static double clamp(double x) {
    return x < 0 ? 0 : x > 1 ? 1 : x;
}

/* The places of the nearest points along two segments (Ericson, Real-Time Collision Detection (2005), section 5.1.9). */
static void segments_nearest(const double u[3], const double v[3], const double w[3], double *s, double *t) {
    double uu = vector_dot(u, u), uv = vector_dot(u, v), vv = vector_dot(v, v), uw = vector_dot(u, w),
           vw = vector_dot(v, w);
    double square = uu * vv - uv * uv;
    *s = square > 1e-14 * uu * vv ? clamp((uw * vv - vw * uv) / square) : 0.5;
    *t = (*s * uv - vw) / vv;
    if (*t < 0 || *t > 1) {
        *t = clamp(*t);
        *s = clamp((*t * uv + uw) / uu);
    }
}

/* The factor of two edges by the square of the sine of their angle, and its slope. */
static double parallel_factor(double sine_square, double *slope) {
    const double full = TOUCH_PARALLEL * TOUCH_PARALLEL, x = sine_square / full;
    *slope = x < 1 ? 6 * x * (1 - x) / full : 0;
    return x < 1 ? x * x * (3 - 2 * x) : 1;
}

struct feature *feature_edges(struct features *features, const struct posed *posed, double roundings,
                              const double *const end[4], uint32_t key) {
    double u[3], v[3], w[3], s, t, on_a[3], way[3];
    for (int d = 0; d < 3; d++) {
        u[d] = end[1][d] - end[0][d];
        v[d] = end[3][d] - end[2][d];
        w[d] = end[2][d] - end[0][d];
    }
    segments_nearest(u, v, w, &s, &t);
    for (int d = 0; d < 3; d++) {
        on_a[d] = end[0][d] + s * u[d];
        way[d] = w[d] + t * v[d] - s * u[d];
    }
    double most = roundings + features->reach, square = vector_dot(way, way),
           lengths = sqrt(vector_dot(u, u) * vector_dot(v, v)), cosine = vector_dot(u, v) / lengths, slope;
    if (!(square > 0 && square < most * most))
        return NULL;
    double distance = sqrt(square), factor = parallel_factor(1 - cosine * cosine, &slope);
    for (int d = 0; d < 3; d++)
        way[d] /= distance;
    struct feature *feature =
        factor > 0 ? feature_add(features, posed, roundings, distance, on_a, way, key) : NULL;
    if (feature == NULL)
        return NULL;
    feature->weight = factor;
    if (feature->overlap < 0)
        return feature;
    cross(v, u, feature->twist); /* the cosine grows by (v x u) . rotation of B */
    for (int d = 0; d < 3; d++)
        feature->twist[d] *= -2 * cosine * slope * feature->overlap / lengths;
    feature->overlap *= factor;
    return feature;
}

/* Adds the share of a feature to the point that it belongs to; where there is no room, the least one goes. */
static void point_give(struct touch *touch, const struct feature *feature, double share, double merge) {
    int least = 0;
    for (int k = 0; k < touch->points; k++) {
        struct touch_point *point = &touch->point[k];
        double off[3];
        for (int d = 0; d < 3; d++)
            off[d] = feature->at[d] - point->at[d];
        if (vector_dot(off, off) < merge * merge) {
            point->share += share;
            return;
        }
        least = point->share < touch->point[least].share ? k : least;
    }
    if (touch->points < TOUCH_POINTS_MAX)
        least = touch->points++;
    else if (touch->point[least].share > share)
        return;
    struct touch_point *point = &touch->point[least];
    *point = (struct touch_point){.share = share, .key = feature->key};
    memcpy(point->at, feature->at, sizeof point->at);
    memcpy(point->normal, feature->normal, sizeof point->normal);
}

double feature_overlap(const struct feature *feature, int count) {
    double most = 0, sum = 0;
    for (int k = 0; k < count; k++)
        most = fmax(most, feature[k].overlap);
    for (int k = 0; k < count; k++) {
        double part = feature[k].overlap / most, square = part * part;
        sum += square * square * square;
    }
    return most * cbrt(sqrt(sum));
}

void feature_sum(const struct feature *all, int count, const double apart[3], double merge,
                 struct touch *touch) {
    touch->overlap = feature_overlap(all, count);
    for (int k = 0; k < count; k++) {
        const struct feature *feature = &all[k];
        const double part = feature->overlap / touch->overlap, share = part * part * part * part * part;
        double arm[2][3], push[3], torque[3];
        for (int d = 0; d < 3; d++) {
            push[d] = share * feature->weight * feature->normal[d];
            arm[0][d] = feature->at[d];
            arm[1][d] = feature->at[d] - apart[d];
            touch->push[d] += push[d];
        }
        for (int side = 0; side < 2; side++) {
            const double sign = side ? 1 : -1;
            cross(arm[side], push, torque);
            for (int d = 0; d < 3; d++)
                touch->turn[side][d] += sign * (torque[d] - share * feature->twist[d]);
        }
        point_give(touch, feature, share, merge);
    }
}
