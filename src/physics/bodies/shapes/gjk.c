/* SPDX-License-Identifier: BSD-3-Clause */
/* The walk of a simplex to the origin. Read gjk.h first. */
#include "physics/bodies/shapes/gjk.h"
#include "base/vector.h"
#include <math.h>
#include <string.h>

enum { ROUNDS_MAX = 100 };

/* A round must bring the square of the distance down by more than this part of it. */
static const double least_gain = 1e-14;

/* Sets that are nearer than this part of their size count as overlapping. */
static const double touch_part = 1e-6;

/* A corner of the difference, and of which corners it is the difference. */
struct point {
    double x[3];
    uint8_t a, b;
};

/* Corners with the weights of the point nearest to the origin. */
struct walk {
    int count;
    struct point point[4];
    double weight[4];
};

static void minus(const double a[3], const double b[3], double c[3]) {
    for (int d = 0; d < 3; d++)
        c[d] = a[d] - b[d];
}

static void point_set(const struct gjk_set *a, const struct gjk_set *b, const double apart[3], int i, int j,
                      struct point *point) {
    for (int d = 0; d < 3; d++)
        point->x[d] = (apart[d] + b->corner[j][d]) - a->corner[i][d];
    point->a = (uint8_t)i;
    point->b = (uint8_t)j;
}

/* The corner of a set that is farthest along a direction. */
static int farthest(const struct gjk_set *set, const double direction[3], double sign) {
    int best = 0;
    double most = -INFINITY;
    for (int k = 0; k < set->corners; k++) {
        double along = sign * vector_dot(set->corner[k], direction);
        if (along > most) {
            most = along;
            best = k;
        }
    }
    return best;
}

/* A walk on one, two or three points of another one. */
static struct walk some(const struct walk *of, int count, const int which[3]) {
    struct walk walk = {.count = count};
    for (int k = 0; k < count; k++)
        walk.point[k] = of->point[which[k]];
    return walk;
}

static void place_of(const struct walk *walk, double x[3]) {
    for (int d = 0; d < 3; d++) {
        x[d] = 0;
        for (int k = 0; k < walk->count; k++)
            x[d] += walk->weight[k] * walk->point[k].x[d];
    }
}

static double square_of(const struct walk *walk) {
    double x[3];
    place_of(walk, x);
    return vector_dot(x, x);
}

/* The part of a segment nearest to the origin. */
static struct walk of_segment(const struct walk *segment) {
    const double *a = segment->point[0].x, *b = segment->point[1].x;
    double along[3];
    minus(b, a, along);
    double length = vector_dot(along, along), t = length > 0 ? -vector_dot(a, along) / length : 0;
    struct walk walk = *segment;
    if (t <= 0 || t >= 1) {
        walk = some(segment, 1, (int[3]){t <= 0 ? 0 : 1});
        walk.weight[0] = 1;
        return walk;
    }
    walk.weight[0] = 1 - t;
    walk.weight[1] = t;
    return walk;
}

static struct walk better(struct walk one, struct walk other) {
    return square_of(&other) < square_of(&one) ? other : one;
}

/* The part of a triangle nearest to the origin: inside by the weights of the foot, else the nearest of its sides. */
static struct walk of_triangle(const struct walk *triangle) {
    const double *a = triangle->point[0].x, *b = triangle->point[1].x, *c = triangle->point[2].x;
    double u[3], v[3];
    minus(b, a, u);
    minus(c, a, v);
    double uu = vector_dot(u, u), uv = vector_dot(u, v), vv = vector_dot(v, v), ua = -vector_dot(u, a),
           va = -vector_dot(v, a);
    double area = uu * vv - uv * uv;
    if (area > 1e-20 * uu * vv) {
        double s = (vv * ua - uv * va) / area, t = (uu * va - uv * ua) / area;
        if (s > 0 && t > 0 && s + t < 1) {
            struct walk walk = *triangle;
            walk.weight[0] = 1 - s - t;
            walk.weight[1] = s;
            walk.weight[2] = t;
            return walk;
        }
    }
    struct walk best = {0};
    for (int k = 0; k < 3; k++) {
        struct walk side = some(triangle, 2, (int[3]){k, (k + 1) % 3});
        side = of_segment(&side);
        best = k == 0 ? side : better(best, side);
    }
    return best;
}

/* The part of a tetrahedron nearest to the origin; all four points: the origin is inside. */
static struct walk of_tetrahedron(const struct walk *four) {
    static const int side[4][4] = {{0, 1, 2, 3}, {0, 3, 1, 2}, {0, 2, 3, 1}, {1, 3, 2, 0}};
    struct walk best = *four;
    bool outside = false;
    for (int f = 0; f < 4; f++) {
        const double *a = four->point[side[f][0]].x;
        double u[3], v[3], w[3], normal[3];
        minus(four->point[side[f][1]].x, a, u);
        minus(four->point[side[f][2]].x, a, v);
        minus(four->point[side[f][3]].x, a, w);
        normal[0] = u[1] * v[2] - u[2] * v[1];
        normal[1] = u[2] * v[0] - u[0] * v[2];
        normal[2] = u[0] * v[1] - u[1] * v[0];
        double inner = vector_dot(normal, w), origin = -vector_dot(normal, a);
        bool flat = inner * inner <= 1e-24 * vector_dot(normal, normal) * vector_dot(w, w);
        if (!flat && inner * origin >= 0)
            continue;
        struct walk face = some(four, 3, side[f]);
        face = of_triangle(&face);
        best = outside ? better(best, face) : face;
        outside = true;
    }
    return best;
}

static struct walk nearest_part(const struct walk *walk) {
    struct walk one = *walk;
    one.weight[0] = 1;
    return walk->count == 1   ? one
           : walk->count == 2 ? of_segment(walk)
           : walk->count == 3 ? of_triangle(walk)
                              : of_tetrahedron(walk);
}

static bool has(const struct walk *walk, int a, int b) {
    for (int k = 0; k < walk->count; k++)
        if (walk->point[k].a == a && walk->point[k].b == b)
            return true;
    return false;
}

/* The start of the walk, from the simplex of the step before or from the first corners. */
static struct walk start(const struct gjk_set *a, const struct gjk_set *b, const double apart[3],
                         const struct gjk_simplex *simplex) {
    struct walk walk = {.count = 1};
    point_set(a, b, apart, 0, 0, &walk.point[0]);
    for (int k = 0; k < simplex->count; k++)
        point_set(a, b, apart, simplex->a[k], simplex->b[k], &walk.point[k]);
    walk.count = simplex->count > 1 ? simplex->count : 1;
    return nearest_part(&walk);
}

/* The nearest points of both sets. */
static void finish(const struct walk *walk, const struct gjk_set *a, const struct gjk_set *b,
                   const double apart[3], struct gjk_nearest *nearest) {
    double x[3];
    place_of(walk, x);
    nearest->distance = sqrt(vector_dot(x, x));
    for (int d = 0; d < 3; d++) {
        nearest->normal[d] = x[d] / nearest->distance;
        nearest->on_a[d] = nearest->on_b[d] = 0;
        for (int k = 0; k < walk->count; k++) {
            nearest->on_a[d] += walk->weight[k] * a->corner[walk->point[k].a][d];
            nearest->on_b[d] += walk->weight[k] * (apart[d] + b->corner[walk->point[k].b][d]);
        }
    }
}

static double size_of(const struct gjk_set *set) {
    double most = 0;
    for (int k = 0; k < set->corners; k++)
        most = fmax(most, vector_dot(set->corner[k], set->corner[k]));
    return sqrt(most);
}

bool gjk_distance(const struct gjk_set *a, const struct gjk_set *b, const double apart[3],
                  struct gjk_simplex *simplex, struct gjk_nearest *nearest) {
    struct walk walk = start(a, b, apart, simplex);
    const double small = touch_part * (size_of(a) + size_of(b));
    double square = walk.count == 4 ? 0 : square_of(&walk);
    nearest->rounds = 0;
    while (square > small * small && nearest->rounds++ < ROUNDS_MAX) {
        double x[3];
        place_of(&walk, x);
        int i = farthest(a, x, 1), j = farthest(b, x, -1);
        struct walk next = walk;
        struct point *point = &next.point[next.count++];
        point_set(a, b, apart, i, j, point);
        if (has(&walk, i, j) || square - vector_dot(x, point->x) <= least_gain * square)
            break;
        next = nearest_part(&next);
        double now = next.count == 4 ? 0 : square_of(&next);
        if (!(now < square))
            break;
        walk = next;
        square = now;
    }
    simplex->count = walk.count == 4 ? 0 : walk.count;
    for (int k = 0; k < simplex->count; k++) {
        simplex->a[k] = walk.point[k].a;
        simplex->b[k] = walk.point[k].b;
    }
    if (!(square > small * small))
        return false;
    finish(&walk, a, b, apart, nearest);
    return true;
}
