/* SPDX-License-Identifier: BSD-3-Clause */
/* Tries all axes that may part two solids. Read deep.h first. */
#include "physics/bodies/shapes/deep.h"
#include "base/vector.h"
#include <math.h>
#include <string.h>

/* Edges whose directions differ by less than this angle have no axis of their own: faces beside them have it. */
static const double parallel = 1e-8;

struct search {
    const struct posed *a, *b;
    const double *apart;
    double least, normal[3];
};

/* How far a solid reaches along an axis. */
static double reach(const struct posed *posed, const double axis[3], double sign) {
    double most = -INFINITY;
    for (int k = 0; k < posed->core->corners; k++)
        most = fmax(most, sign * vector_dot(posed->corner[k], axis));
    return most;
}

/* Moving B along the axis. */
static void axis_try(struct search *search, const double axis[3]) {
    double overlap = reach(search->a, axis, 1) + reach(search->b, axis, -1) - vector_dot(search->apart, axis);
    if (overlap < search->least) {
        search->least = overlap;
        memcpy(search->normal, axis, sizeof search->normal);
    }
}

static void faces_try(struct search *search, const struct posed *posed, double sign) {
    for (int f = 0; f < posed->core->faces; f++) {
        double axis[3];
        posed_normal(posed, f, axis);
        for (int d = 0; d < 3; d++)
            axis[d] *= sign;
        axis_try(search, axis);
    }
}

static void edge_of(const struct posed *posed, int number, double along[3]) {
    const int *end = posed->core->edge[number].end;
    for (int d = 0; d < 3; d++)
        along[d] = posed->corner[end[1]][d] - posed->corner[end[0]][d];
}

static void edges_try(struct search *search) {
    for (int i = 0; i < search->a->core->edges; i++)
        for (int j = 0; j < search->b->core->edges; j++) {
            double u[3], v[3], axis[3];
            edge_of(search->a, i, u);
            edge_of(search->b, j, v);
            for (int d = 0; d < 3; d++) {
                int e = (d + 1) % 3, f = (d + 2) % 3;
                axis[d] = u[e] * v[f] - u[f] * v[e];
            }
            double square = vector_dot(axis, axis);
            if (square <= parallel * parallel * vector_dot(u, u) * vector_dot(v, v))
                continue;
            for (int sign = -1; sign <= 1; sign += 2) {
                double unit[3];
                for (int d = 0; d < 3; d++)
                    unit[d] = sign * axis[d] / sqrt(square);
                axis_try(search, unit);
            }
        }
}

double deep_overlap(const struct posed *a, const struct posed *b, const double apart[3], double normal[3]) {
    struct search search = {.a = a, .b = b, .apart = apart, .least = INFINITY};
    faces_try(&search, a, 1);
    faces_try(&search, b, -1);
    edges_try(&search);
    memcpy(normal, search.normal, sizeof search.normal);
    return search.least;
}
