/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums and integrals over spheres, solids and sheets. The quaternion of a rotation. Read moments.h first. */
#include "base/moments.h"
#include "base/memory.h"
#include <math.h>
#include <stdlib.h>

/* Integrals over a body: of 1, x, and x x. */
struct integrals {
    double one, x[3], xx[9];
};

static void moments_of(const struct integrals *all, struct moments *moments) {
    double spread[9], trace = 0;
    moments->volume = all->one;
    for (int d = 0; d < 3; d++)
        moments->centre[d] = all->x[d] / all->one;
    for (int d = 0; d < 3; d++)
        for (int e = 0; e < 3; e++)
            spread[3 * d + e] = all->xx[3 * d + e] / all->one - moments->centre[d] * moments->centre[e];
    for (int d = 0; d < 3; d++)
        trace += spread[4 * d];
    for (int k = 0; k < 9; k++)
        moments->gyration[k] = (k % 4 == 0 ? trace : 0) - spread[k];
}

void moments_sum(const struct clump_sphere *sphere, int spheres, struct moments *moments) {
    struct integrals all = {0};
    for (int k = 0; k < spheres; k++) {
        const double *x = sphere[k].centre, r = sphere[k].radius, volume = 4 * M_PI / 3 * r * r * r;
        all.one += volume;
        for (int d = 0; d < 3; d++) {
            all.x[d] += volume * x[d];
            for (int e = 0; e < 3; e++)
                all.xx[3 * d + e] += volume * (x[d] * x[e] + (d == e ? 0.2 * r * r : 0));
        }
    }
    moments_of(&all, moments);
}

static int span_compare(const void *a, const void *b) {
    const double *x = a, *y = b;
    return (x[0] > y[0]) - (x[0] < y[0]);
}

/* Adds a column of cross-section `area` at (x, y) from z0 to z1. */
static void column_add(struct integrals *all, double area, const double at[2], double z0, double z1) {
    double one = area * (z1 - z0), z = 0.5 * (z0 + z1), zz = (z0 * z0 + z0 * z1 + z1 * z1) / 3;
    const double x[3] = {at[0], at[1], z};
    all->one += one;
    for (int d = 0; d < 3; d++) {
        all->x[d] += one * x[d];
        for (int e = 0; e < 3; e++)
            all->xx[3 * d + e] += one * (d == 2 && e == 2 ? zz : x[d] * x[e]);
    }
}

/* Adds the union of the spheres' spans of z over (x, y). `span` has room for all. */
static void column_of(struct integrals *all, double area, const double at[2],
                      const struct clump_sphere *sphere, int spheres, double (*span)[2]) {
    int n = 0;
    for (int k = 0; k < spheres; k++) {
        double dx = at[0] - sphere[k].centre[0], dy = at[1] - sphere[k].centre[1];
        double square = sphere[k].radius * sphere[k].radius - (dx * dx + dy * dy);
        if (square <= 0)
            continue;
        span[n][0] = sphere[k].centre[2] - sqrt(square);
        span[n++][1] = sphere[k].centre[2] + sqrt(square);
    }
    qsort(span, (size_t)n, sizeof *span, span_compare);
    for (int k = 0; k < n;) {
        double first = span[k][0], last = span[k][1];
        for (k++; k < n && span[k][0] <= last; k++)
            last = fmax(last, span[k][1]);
        column_add(all, area, at, first, last);
    }
}

void moments_union(const struct clump_sphere *sphere, int spheres, struct moments *moments) {
    enum { WORK = 1 << 25, LEAST = 128, MOST = 1024 };
    double lower[2] = {INFINITY, INFINITY}, upper[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < spheres; k++)
        for (int d = 0; d < 2; d++) {
            lower[d] = fmin(lower[d], sphere[k].centre[d] - sphere[k].radius);
            upper[d] = fmax(upper[d], sphere[k].centre[d] + sphere[k].radius);
        }
    int wanted = (int)sqrt((double)WORK / spheres), n = wanted < LEAST  ? LEAST
                                                        : wanted > MOST ? MOST
                                                                        : wanted;
    double step = fmax(upper[0] - lower[0], upper[1] - lower[1]) / n;
    struct integrals all = {0};
    double(*span)[2] = memory_allocate((size_t)spheres, sizeof *span, "spans of spheres");
    for (int i = 0; lower[0] + i * step < upper[0]; i++)
        for (int j = 0; lower[1] + j * step < upper[1]; j++) {
            const double at[2] = {lower[0] + (i + 0.5) * step, lower[1] + (j + 0.5) * step};
            column_of(&all, step * step, at, sphere, spheres, span);
        }
    memory_free(span);
    moments_of(&all, moments);
}

/* Adds the tetrahedron of the origin and three corners: with s the sum of the corners, the integral of x_i is V s_i / 4,
 * and that of x_i x_j is V (s_i s_j + sum over corners of x_i x_j) / 20. */
static void tetrahedron_add(struct integrals *all, const double p[9]) {
    double volume = (p[0] * (p[4] * p[8] - p[5] * p[7]) - p[1] * (p[3] * p[8] - p[5] * p[6]) +
                     p[2] * (p[3] * p[7] - p[4] * p[6])) /
                    6;
    double s[3];
    for (int d = 0; d < 3; d++)
        s[d] = p[d] + p[3 + d] + p[6 + d];
    all->one += volume;
    for (int d = 0; d < 3; d++) {
        all->x[d] += volume * s[d] / 4;
        for (int e = 0; e < 3; e++)
            all->xx[3 * d + e] +=
                volume * (s[d] * s[e] + p[d] * p[e] + p[3 + d] * p[3 + e] + p[6 + d] * p[6 + e]) / 20;
    }
}

void moments_solid(const double (*corner)[9], size_t triangles, struct moments *moments) {
    struct integrals all = {0};
    for (size_t t = 0; t < triangles; t++) {
        double from[9];
        for (int c = 0; c < 9; c++)
            from[c] = corner[t][c] - corner[0][c % 3];
        tetrahedron_add(&all, from);
    }
    double sign = all.one < 0 ? -1 : 1; /* triangles that run round inwards */
    all.one *= sign;
    for (int d = 0; d < 3; d++)
        all.x[d] *= sign;
    for (int k = 0; k < 9; k++)
        all.xx[k] *= sign;
    moments_of(&all, moments);
    for (int d = 0; d < 3; d++)
        moments->centre[d] += corner[0][d];
}

/* Adds a triangle: with s the sum of the corners, the integral of x_i is A s_i / 3, and that of x_i x_j is
 * A (s_i s_j + sum over corners of x_i x_j) / 12. */
static void triangle_add(struct integrals *all, const double p[9]) {
    double u[3], v[3], s[3], square = 0;
    for (int d = 0; d < 3; d++) {
        u[d] = p[3 + d] - p[d];
        v[d] = p[6 + d] - p[d];
        s[d] = p[d] + p[3 + d] + p[6 + d];
    }
    for (int d = 0; d < 3; d++) {
        double across = u[(d + 1) % 3] * v[(d + 2) % 3] - u[(d + 2) % 3] * v[(d + 1) % 3];
        square += across * across;
    }
    const double area = 0.5 * sqrt(square);
    all->one += area;
    for (int d = 0; d < 3; d++) {
        all->x[d] += area * s[d] / 3;
        for (int e = 0; e < 3; e++)
            all->xx[3 * d + e] +=
                area * (s[d] * s[e] + p[d] * p[e] + p[3 + d] * p[3 + e] + p[6 + d] * p[6 + e]) / 12;
    }
}

void moments_sheet(const double (*corner)[9], size_t triangles, struct moments *moments) {
    struct integrals all = {0};
    for (size_t t = 0; t < triangles; t++) {
        double from[9];
        for (int c = 0; c < 9; c++)
            from[c] = corner[t][c] - corner[0][c % 3];
        triangle_add(&all, from);
    }
    moments_of(&all, moments);
    for (int d = 0; d < 3; d++)
        moments->centre[d] += corner[0][d];
}

void moments_quaternion(const double turn[9], double q[4]) {
    /* four times the squares of w x y z; the largest has the least rounding (Shepperd 1978) */
    const double square[4] = {1 + turn[0] + turn[4] + turn[8], 1 + turn[0] - turn[4] - turn[8],
                              1 - turn[0] + turn[4] - turn[8], 1 - turn[0] - turn[4] + turn[8]};
    int most = 0;
    for (int k = 1; k < 4; k++)
        most = square[k] > square[most] ? k : most;
    const double product[4][4] = {{square[0], turn[7] - turn[5], turn[2] - turn[6], turn[3] - turn[1]},
                                  {turn[7] - turn[5], square[1], turn[1] + turn[3], turn[2] + turn[6]},
                                  {turn[2] - turn[6], turn[1] + turn[3], square[2], turn[5] + turn[7]},
                                  {turn[3] - turn[1], turn[2] + turn[6], turn[5] + turn[7], square[3]}};
    double norm = 0;
    for (int k = 0; k < 4; k++)
        norm += product[most][k] * product[most][k];
    for (int k = 0; k < 4; k++)
        q[k] = product[most][k] / sqrt(norm);
}
