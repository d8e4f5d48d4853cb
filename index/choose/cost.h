/* SPDX-License-Identifier: BSD-3-Clause */
/* The cost of a search: a model of order + build + visit for grids of levels, from the number, sizes and
 * density of the particles alone. `auto` chooses by this model.
 *
 * Ogarko and Luding's estimate, T ~ N L (m + K) for m particles in each cell of L levels, counts candidates
 * and cells per particle. Here most rows are searched in spans and some one by one (search_rows.h),
 * so the counts are, for rows of level g and the tables of levels h >= g, with n_h the number density of h
 * and a cut-off s:
 *
 *   cells       of dense tables, which the build counts through
 *   windows     where g = h and the table is dense: rows x pencils within s of them, half of those
 *   vectors     LANES of candidates in these windows, one vector at least in each
 *   visits      elsewhere: rows of g, once for each h; half a visit where h finds the pairs
 *   runs        spans of at most OWN_ROWS (h = g) or ROWS (h > g) of a pencil x pencils of h that a window of
 *               (edge of g + 2 s) meets; half of them for h = g
 *   round       runs of wide windows, which are cut to a ball pencil by pencil
 *   sparse      runs in tables that are kept sparse (cells.h)
 *   tests       candidates of a span, n_h x (volume of those pencils between the ends of the window), x rows,
 *               LANES at a time. For h > g once a span, and for its rows only if one of them is within reach
 *   singles     rows of h, where they find their pairs with g themselves (cross.h). Their candidates are
 *               counted with the windows and vectors, or with the runs and tests
 *
 * and each has its price. Rows without partners in a table do not search it. Particles are taken to be spread
 * evenly over the volume; a volume that is occupied only in part should be given as the part. Prices were
 * fitted by `bench_index calibrate` (docs/indexes.md).
 */
#ifndef SCREE_INDEX_CHOOSE_COST_H
#define SCREE_INDEX_CHOOSE_COST_H

#include "index/prices.h"
#include "index/index.h"

enum { COST_BINS = 64 };

/* Sizes of the particles, in bins from small to large, and the room they have. */
struct cost_scene {
    int bins;
    double count[COST_BINS];      /* particles; a bin may be empty */
    double radius_min[COST_BINS]; /* smallest and largest in the bin, length unit; ascending */
    double radius_max[COST_BINS];
    double volume; /* occupied volume (2D: area), length unit^dimension */
    int dimension;
    int threads;
    double margin[COST_BINS]; /* of a pair whose smaller particle is the smallest of its level, in this bin */
    bool classes; /* bins are size classes: a level of several holds them mixed, which costs more, */
                  /* and its margin is that of its last bin */
    uint64_t unwanted[COST_BINS]; /* bit b of entry a: particles of the bins a and b never meet; symmetric */
};

/* Levels: level g holds the bins after the last one of level g - 1 to last[g]. */
struct cost_plan {
    int levels;
    int last[INDEX_CLASS_MAX];
    double edge[INDEX_CLASS_MAX]; /* cell edge in y and z, length unit */
};

/* One level as the model sees it: its particles, and its cells. */
struct cost_level {
    int first, last; /* bins */
    double count, radius_max, radius_mean, margin;
    double density;          /* particles a length unit^dimension */
    double across;           /* edge of a cube (2D: a square) of the occupied volume, length unit */
    bool mixed;              /* several classes with particles */
    uint64_t bins, unwanted; /* bins with particles; bins that particles of some bin never meet */
    double edge;             /* of the cells, length unit */
    double cells;            /* their number */
    double pencils, pencil;  /* pencils of cells, and particles in one of them */
    bool sparse;
    double span_radius[2]; /* largest radius to be expected in a span: own, other */
};

/* A plan with the cost of each pair of its levels. A change of one level prices the pairs of this level again,
 * and no others: its cost grows with the number of levels, not with its square. */
struct cost_sheet {
    const struct cost_scene *scene; /* the caller keeps it */
    int levels;
    struct cost_level level[INDEX_CLASS_MAX];
    double pair[INDEX_CLASS_MAX][INDEX_CLASS_MAX]; /* [g][h], g <= h: nanoseconds, of all threads together */
};

void cost_sheet_make(struct cost_sheet *sheet, const struct cost_scene *scene, const struct cost_plan *plan);

/* Gives a level cells of this edge. */
void cost_sheet_edge(struct cost_sheet *sheet, int level, double edge);

/* Makes one level, with cells of its cut-off, of the levels `level` and `level` + 1. */
void cost_sheet_join(struct cost_sheet *sheet, int level);

/* What cost_seconds says of the plan. */
double cost_sheet_seconds(const struct cost_sheet *sheet);

void cost_sheet_plan(const struct cost_sheet *sheet, struct cost_plan *plan);

/* Counts the events of a plan; the work of all threads together. */
void cost_count(const struct cost_scene *scene, const struct cost_plan *plan, double count[COST_TERMS]);

/* Seconds that one rebuild should take on the scene's number of threads. */
double cost_seconds(const struct cost_scene *scene, const struct cost_plan *plan);

/* Writes one line with the parts of the cost. */
void cost_why(const struct cost_scene *scene, const struct cost_plan *plan, char why[INDEX_WHY_MAX]);

/* Name of a term. */
const char *cost_name(enum cost_term term);

/* The cut-off, 2 radius + margin, that the cells of a level are made from; 0 if the level has no particles. */
double cost_cutoff(const struct cost_scene *scene, const struct cost_plan *plan, int level);
double cost_level_cutoff(const struct cost_level *level);

#endif
