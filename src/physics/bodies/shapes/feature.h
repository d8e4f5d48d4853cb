/* SPDX-License-Identifier: BSD-3-Clause */
/* The features of a contact, and their sum. Read touch.h first, whose part this is. */
#ifndef SCREE_SHAPES_FEATURE_H
#define SCREE_SHAPES_FEATURE_H

#include "physics/bodies/shapes/posed.h"
#include "physics/bodies/shapes/touch_point.h"

enum { FEATURES_MAX = 256 };

struct feature {
    double overlap; /* d_k, > 0; below 0 within the reach */
    double at[3], normal[3],
        weight;      /* weight: slope of d_k along the normal, 1 but of edges that are nearly parallel */
    double twist[3]; /* slope of d_k in a rotation of B */
    uint32_t key;
    int32_t group; /* features of different groups are contacts of their own; 0 of two solids */
};

struct features {
    int count;
    double reach; /* features whose gap is less count, too; 0: those that overlap */
    struct feature feature[FEATURES_MAX];
};

/* Adds a feature of this distance, whose nearest point of A is on_a; nothing if it is out of reach. Returns it, or NULL. */
struct feature *feature_add(struct features *features, const struct posed *a, double roundings,
                            double distance, const double on_a[3], const double normal[3], uint32_t key);

/* Fills the overlap, the push, the turns and the points of a contact. `merge`: features that are nearer to each other are one
 * point. */
void feature_sum(const struct feature *all, int count, const double apart[3], double merge,
                 struct touch *touch);

/* The norm d of the overlaps (touch.h). */
double feature_overlap(const struct feature *feature, int count);

/* Adds two edges, from a to b and from c to e, all about the centre of A. Returns the feature, or NULL. An overlap has the factor
 * of edges that are nearly parallel in it, a gap has not. */
struct feature *feature_edges(struct features *features, const struct posed *posed, double roundings,
                              const double *const end[4], uint32_t key);

#endif
