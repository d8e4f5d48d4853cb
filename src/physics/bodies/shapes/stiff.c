/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums the slopes of the features of a contact. Read stiff.h first. */
#include "physics/bodies/shapes/stiff.h"
#include "base/eigen3.h"
#include "base/eigen6.h"
#include "base/vector.h"
#include "base/rotor.h"
#include "physics/bodies/shapes/touch.h"
#include <math.h>
#include <string.h>

/* The overlap with a plane over the rounding. */
static const double seat_part = 1e-3;

static void add_square(double matrix[36], double weight, const double row[6]) {
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++)
            matrix[6 * i + j] += weight * row[i] * row[j];
}

/* The six slopes of a move `along` and a rotation `about` in space, in the frame of the solid. */
static void row_make(const struct stiff_side *side, const double along[3], const double about[3],
                     double row[6]) {
    rotor_turn_back(side->turn, along, row);
    rotor_turn_back(side->turn, about, row + 3);
    for (int d = 0; d < 3; d++)
        row[3 + d] /= sqrt(side->gyration[d]);
}

/* Springs across the normal of a feature: 1 - n n^T at its place. */
static void across_add(double matrix[36], const struct stiff_side *side, const double arm[3],
                       const double normal[3], double share) {
    double row[6], about[3];
    for (int d = 0; d < 3; d++) {
        double axis[3] = {d == 0, d == 1, d == 2};
        vector_cross(arm, axis, about);
        row_make(side, axis, about, row);
        add_square(matrix, share, row);
    }
    vector_cross(arm, normal, about);
    row_make(side, normal, about, row);
    add_square(matrix, -share, row);
}

void stiff_find(const struct feature *all, int count, const struct stiff_side *side, double q,
                struct stiff *stiff) {
    const double overlap = feature_overlap(all, count);
    double sum[6] = {0};
    *stiff = (struct stiff){0};
    for (int k = 0; k < count; k++) {
        const struct feature *feature = &all[k];
        double part = feature->overlap / overlap, fourth = part * part * part * part, arm[3], along[3],
               about[3], row[6];
        for (int d = 0; d < 3; d++) {
            arm[d] = feature->at[d] - (side->second ? side->apart[d] : 0);
            along[d] = feature->weight * feature->normal[d];
        }
        vector_cross(arm, along, about);
        for (int d = 0; d < 3; d++)
            about[d] -= feature->twist[d];
        row_make(side, along, about, row);
        add_square(stiff->matrix[STIFF_ALONG], 5 * q * fourth, row);
        add_square(stiff->matrix[STIFF_DAMPED], fourth * part, row);
        for (int c = 0; c < 6; c++)
            sum[c] += fourth * part * row[c];
        across_add(stiff->matrix[STIFF_ACROSS], side, arm, feature->normal, fourth * part);
    }
    add_square(stiff->matrix[STIFF_ALONG], 1 - 5 * q, sum);
}

double stiff_largest(const struct stiff *stiff, const double weight[STIFF_KINDS]) {
    double matrix[36] = {0};
    for (int m = 0; m < STIFF_KINDS; m++)
        for (int k = 0; k < 36; k++)
            matrix[k] += weight[m] * stiff->matrix[m][k];
    return eigen6_largest(matrix);
}

double stiff_corner(const struct solid *core, const double gyration[3]) {
    double most = 0;
    for (int k = 0; k < core->corners; k++) {
        const double *c = core->corner[k], *g = gyration;
        double x = c[0] * c[0], y = c[1] * c[1], z = c[2] * c[2]; /* [c]^T diag(1/g) [c] */
        const double square[6] = {z / g[1] + y / g[2], z / g[0] + x / g[2], y / g[0] + x / g[1],
                                  -c[0] * c[1] / g[2], -c[0] * c[2] / g[1], -c[1] * c[2] / g[0]};
        most = fmax(most, eigen3_largest(square));
    }
    return 1 + most;
}

/* Raises `seat` to the contact of the solid with a plane that it touches in this direction. */
static void seat_raise(const struct solid *core, double rounding, const double gyration[3],
                       const double direction[3], double seat[STIFF_KINDS]) {
    static const double turn[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const struct posed posed = {core, (const double(*)[3])core->corner, turn, 1, rounding};
    const struct stiff_side side = {.turn = turn, .gyration = {gyration[0], gyration[1], gyration[2]}};
    double top = -INFINITY;
    struct features features;
    struct stiff stiff;
    for (int k = 0; k < core->corners; k++)
        top = fmax(top, vector_dot(core->corner[k], direction));
    const double inward[3] = {-direction[0], -direction[1], -direction[2]};
    if (!touch_plane(&posed, inward, top + (1 - seat_part) * rounding, &features))
        return;
    stiff_find(features.feature, features.count, &side, 1, &stiff);
    for (int m = 0; m < STIFF_KINDS; m++)
        seat[m] = fmax(seat[m], eigen6_largest(stiff.matrix[m]));
}

void stiff_seat(const struct solid *core, double rounding, const double gyration[3],
                double seat[STIFF_KINDS]) {
    for (int m = 0; m < STIFF_KINDS; m++)
        seat[m] = stiff_corner(core, gyration);
    for (int f = 0; f < core->faces; f++)
        seat_raise(core, rounding, gyration, core->face[f].normal, seat);
    for (int e = 0; e < core->edges; e++) {
        const int *face = core->edge[e].face;
        double middle[3], square = 0;
        for (int d = 0; d < 3; d++) {
            middle[d] = core->face[face[0]].normal[d] + core->face[face[1]].normal[d];
            square += middle[d] * middle[d];
        }
        for (int d = 0; d < 3; d++)
            middle[d] /= sqrt(square);
        seat_raise(core, rounding, gyration, middle, seat);
    }
}
