/* SPDX-License-Identifier: BSD-3-Clause */
/* From the nearest points of two solids to the points of their contact. Read touch.h first. */
#include "physics/bodies/shapes/touch.h"
#include "physics/bodies/shapes/face_clip.h"
#include "physics/bodies/shapes/deep.h"
#include <math.h>

/* Faces that are turned farther away from the normal than this cosine have one point. */
static const double steep = 0.5;

/* The points of faces are those of the contact if they reach its overlap to this part. */
static const double same = 1e-6;

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The face that is turned most to a direction; -1: none is near it. */
static int face_toward(const struct posed *posed, const double direction[3]) {
    int best = -1;
    double most = steep;
    for (int f = 0; f < posed->core->faces; f++) {
        double normal[3];
        posed_normal(posed, f, normal);
        double along = dot(normal, direction);
        if (along > most) {
            most = along;
            best = f;
        }
    }
    return best;
}

/* The number of the only corner of a set in the simplex; -1: there are several. */
static int only(const uint8_t *corner, int count) {
    for (int k = 1; k < count; k++)
        if (corner[k] != corner[0])
            return -1;
    return count > 0 ? corner[0] : -1;
}

static uint32_t nearest_key(const struct gjk_simplex *simplex) {
    int a = only(simplex->a, simplex->count), b = only(simplex->b, simplex->count);
    return a >= 0   ? touch_key(TOUCH_CORNER_A, a, 0)
           : b >= 0 ? touch_key(TOUCH_CORNER_B, b, 0)
                    : touch_key(TOUCH_NEAREST, 0, 0);
}

/* The normal, overlap and nearest point of A for cores that overlap: the points that are nearest after a move which parts the
 * cores along the normal. */
static void part(struct touch *touch, const struct posed *a, const struct posed *b, const double apart[3],
                 struct gjk_nearest *nearest) {
    const struct gjk_set set_a = {a->core->corners, a->corner}, set_b = {b->core->corners, b->corner};
    const double both = a->rounding + b->rounding, depth = deep_overlap(a, b, apart, touch->normal);
    struct gjk_simplex simplex = {0};
    double moved[3];
    touch->overlap = both + depth;
    for (int d = 0; d < 3; d++) {
        moved[d] = apart[d] + (depth + both) * touch->normal[d];
        nearest->on_a[d] = 0;
    }
    gjk_distance(&set_a, &set_b, moved, &simplex, nearest);
}

static void keep_nearest(struct touch *touch, const struct posed *a, const double on_a[3], uint32_t key) {
    struct touch_point *point = &touch->point[0];
    touch->points = 1;
    *point = (struct touch_point){.overlap = touch->overlap, .share = 1, .key = key};
    for (int d = 0; d < 3; d++)
        point->at[d] = on_a[d] + (a->rounding - 0.5 * touch->overlap) * touch->normal[d];
}

/* Keeps the point that overlaps most of those with no room. */
static void point_add(struct touch *touch, const struct touch_point *point) {
    int least = 0;
    if (touch->points < TOUCH_POINTS_MAX) {
        touch->point[touch->points++] = *point;
        return;
    }
    for (int k = 1; k < touch->points; k++)
        if (touch->point[k].overlap < touch->point[least].overlap)
            least = k;
    if (point->overlap > touch->point[least].overlap)
        touch->point[least] = *point;
}

/* The points of two faces. False: the nearest points are not among them. */
static bool faces_meet(struct touch *touch, const struct posed *a, const struct posed *b,
                       const double apart[3]) {
    const double back[3] = {-touch->normal[0], -touch->normal[1], -touch->normal[2]};
    int face_a = face_toward(a, touch->normal), face_b = face_toward(b, back);
    if (face_a < 0 || face_b < 0)
        return false;
    struct face_clip clip;
    face_clip_make(&clip, a, face_a, b, face_b, apart, touch->normal);
    double sum = 0, most = 0;
    touch->points = 0;
    for (int k = 0; k < clip.count; k++) {
        struct touch_point point = {.key = clip.corner[k].key};
        double low, high;
        face_clip_heights(&clip, k, &low, &high);
        point.overlap = a->rounding + b->rounding - (high - low);
        if (!(point.overlap > 0))
            continue;
        double middle = low + a->rounding - 0.5 * point.overlap;
        for (int d = 0; d < 3; d++)
            point.at[d] = clip.corner[k].at[0] * clip.axis[0][d] + clip.corner[k].at[1] * clip.axis[1][d] +
                          middle * touch->normal[d];
        point_add(touch, &point);
        most = fmax(most, point.overlap);
    }
    for (int k = 0; k < touch->points; k++)
        sum += touch->point[k].overlap;
    for (int k = 0; k < touch->points; k++)
        touch->point[k].share = touch->point[k].overlap / sum;
    return most >= touch->overlap * (1 - same);
}

bool touch_find(const struct posed *a, const struct posed *b, const double apart[3],
                struct gjk_simplex *simplex, struct touch *touch) {
    const struct gjk_set set_a = {a->core->corners, a->corner}, set_b = {b->core->corners, b->corner};
    struct gjk_nearest nearest;
    uint32_t key = touch_key(TOUCH_NEAREST, 0, 0);
    if (gjk_distance(&set_a, &set_b, apart, simplex, &nearest)) {
        touch->overlap = a->rounding + b->rounding - nearest.distance;
        for (int d = 0; d < 3; d++)
            touch->normal[d] = nearest.normal[d];
        key = nearest_key(simplex);
    } else {
        part(touch, a, b, apart, &nearest);
    }
    if (!(touch->overlap > 0))
        return false;
    if (!faces_meet(touch, a, b, apart))
        keep_nearest(touch, a, nearest.on_a, key);
    return true;
}
