/* SPDX-License-Identifier: BSD-3-Clause */
/* The choice of contact points between two bodies. Read thin.h first. */
#include "physics/hard/thin.h"
#include <math.h>
#include <stdlib.h>

/* Normals of one direction: the cosine of 20 degrees. A point that pressed counts as so much farther away, one that does not touch
 * as so much nearer. */
static const double alike = 0.94, pressed_more = 1.2, open_less = 0.5;

static int by_bodies(const void *a, const void *b) {
    const struct hard_point *x = a, *y = b;
    if (x->bodies != y->bodies)
        return x->bodies < y->bodies ? -1 : 1;
    return x->order < y->order ? -1 : x->order > y->order;
}

static double along(const struct hard_point *a, const struct hard_point *b) {
    return a->normal[0] * b->normal[0] + a->normal[1] * b->normal[1] + a->normal[2] * b->normal[2];
}

static double apart(const struct hard_point *a, const struct hard_point *b) {
    double square = 0.0;
    for (int d = 0; d < 3; d++)
        square += (a->place[d] - b->place[d]) * (a->place[d] - b->place[d]);
    return sqrt(square);
}

static double worth(const struct hard_point *point) {
    return point->pressed ? pressed_more : point->gap > 0.0 ? open_less : 1.0;
}

/* Keeps points of the direction of `first`, which is kept; takes the others of it away. `left` has the points that are not
 * decided. Returns how many of these remain. */
static size_t direction_choose(struct hard_point *first, struct hard_point **left, size_t count) {
    struct hard_point *kept[HARD_POINTS] = {first};
    size_t rest = 0;
    for (int n = 1; n < HARD_POINTS; n++) {
        double farthest = 0.0;
        kept[n] = NULL;
        for (size_t k = 0; k < count; k++) {
            double least = INFINITY;
            if (left[k]->keep || along(left[k], first) < alike)
                continue;
            for (int m = 0; m < n; m++)
                least = fmin(least, apart(left[k], kept[m]));
            if (least * worth(left[k]) > farthest) {
                farthest = least * worth(left[k]);
                kept[n] = left[k];
            }
        }
        if (kept[n] == NULL)
            break;
        kept[n]->keep = true;
    }
    for (size_t k = 0; k < count; k++)
        if (along(left[k], first) < alike)
            left[rest++] = left[k];
    return rest;
}

/* The points of one pair of bodies, in runs that fit into `left`. */
static void pair_choose(struct hard_point *point, size_t points) {
    enum { MOST = 1024 };
    struct hard_point *left[MOST];
    size_t count = points < MOST ? points : MOST;
    for (size_t k = 0; k < points; k++)
        point[k].keep = points <= HARD_POINTS || k >= MOST;
    for (size_t k = 0; k < count; k++)
        left[k] = &point[k];
    while (points > HARD_POINTS && count > 0) {
        struct hard_point *deepest = left[0];
        for (size_t k = 1; k < count; k++)
            if (left[k]->gap < deepest->gap)
                deepest = left[k];
        deepest->keep = true;
        count = direction_choose(deepest, left, count);
    }
}

void hard_thin(struct hard_point *point, size_t points) {
    if (points > 1)
        qsort(point, points, sizeof *point, by_bodies);
    for (size_t first = 0, end; first < points; first = end) {
        for (end = first + 1; end < points && point[end].bodies == point[first].bodies;)
            end++;
        pair_choose(point + first, end - first);
    }
}
