/* SPDX-License-Identifier: BSD-3-Clause */
/* Random clouds of particles for the tests of the indexes, and the comparison of sets of pairs. */
#ifndef SCREE_TESTS_INDEX_INDEX_CLOUD_H
#define SCREE_TESTS_INDEX_INDEX_CLOUD_H

#include "index/index.h"

enum cloud_sizes {
    CLOUD_MONO,
    CLOUD_BIDISPERSE, /* radii 1 and `ratio`, a few large ones */
    CLOUD_POWER,      /* continuous, number density ~ r^-3, 1 ... ratio, classes of ratio 2 */
    CLOUD_ONE_CLASS,  /* the same sizes, all in one class */
    CLOUD_BOULDER,    /* dust and `large` boulders of radius ratio */
};

enum cloud_places {
    CLOUD_UNIFORM,
    CLOUD_ONE_SPOT,  /* all within a cut-off */
    CLOUD_FACES,     /* on multiples of a quarter of the edge: cell and box faces, many of them twice */
    CLOUD_CLUSTERED, /* a dense corner of a large box */
    CLOUD_OUTLIERS   /* a few absurdly far outside (open directions only) */
};

enum cloud_margins { CLOUD_MARGIN_SAME, CLOUD_MARGIN_RELATIVE, CLOUD_MARGIN_MIXED };

struct cloud_spec {
    const char *name;
    size_t count, large;
    enum cloud_sizes sizes;
    double ratio;
    enum cloud_places places;
    enum cloud_margins margins;
    double fraction; /* volume fraction, sets the box; or */
    double edge[3];  /* the box, where [0] > 0 */
    int dimension;
    bool periodic[3];
    double ghosts; /* share of the particles that are ghosts */
    bool around;   /* ghosts lie around the others, beyond the box in an open direction, not among them */
    bool newton;
    double unwanted;   /* share of the class pairs that never meet, drawn by the seed; 0: all may */
    bool loose_bounds; /* radius_max of the classes larger than their largest particle */
    uint64_t seed;
};

struct cloud {
    struct index_view view;
    double *record; /* stride 5: x y z radius unused */
    uint8_t *size_class;
    int64_t *id;
};

void index_cloud_make(struct cloud *cloud, const struct cloud_spec *spec);
void index_cloud_free(struct cloud *cloud);

/* Applies an order to the owned particles, as a rebuild does. */
void index_cloud_reorder(struct cloud *cloud, const uint32_t *order);

/* A set of pairs as sorted keys; pairs of owned particles in one orientation. Particles are named by id, so
 * that sets before and after a reorder compare. */
struct pair_set {
    uint64_t *key;
    size_t count;
};

/* The key of the pair (i, j & image) of a view; _sort puts the keys of a set in order. */
uint64_t pair_key(const struct index_view *view, uint32_t i, uint32_t tagged);
void pair_set_sort(struct pair_set *set);

/* Collects the pairs of a built index, visiting [0, owned) in `parts` ranges of uneven size. Fails the test
 * if a count-only visit counts differently, or a sink that is too small is overrun. */
void pair_set_collect(struct pair_set *set, const struct index *index, const struct index_view *view,
                      int parts);
void pair_set_free(struct pair_set *set);

/* Fails the test, naming the first difference, if the sets differ. */
void pair_set_compare(const struct pair_set *expected, const struct pair_set *found, const char *what);

/* Makes, builds and checks an index; fails the test if it is refused or inconsistent. */
struct index *cloud_index(const struct cloud *cloud, const char *name, const struct index_params *params);

#endif
