/* A set of grids, each with the particles of some classes, and what rows of each class search: the common
 * body of linkcell, multi, bytype and hgrid, which differ in how they share out the classes and size the
 * cells.
 *
 * What a row of class c searches (i the row, own = the grid of its class):
 *
 *   table                            which pairs are kept                                      rule
 *   owned of its own grid            partners in later slots: each pair once, whatever image   half
 *   owned of grids of larger classes all: the smaller looks up the larger                      full
 *   owned of grids of smaller        none; or all, at the build, where that costs less         full
 *   ghosts of its own grid           newton on: those whose home is i; off: all                home, full
 *   ghosts of grids of larger        all: the smaller is the home                              full
 *   ghosts of grids of smaller       newton on: none; off: all                                 none, full
 *
 * Where the larger are few, they look up the smaller at the build instead (cross.h), and no row of the
 * smaller searches their table. */
#ifndef SCREE_INDEX_GRIDS_LEVELS_H
#define SCREE_INDEX_GRIDS_LEVELS_H

#include "index/grids/cells.h"
#include "index/grids/cross.h"
#include "index/grids/stencil.h"

/* What an index decides. */
struct levels_plan {
    int grids;
    int grid_of[INDEX_CLASS_MAX]; /* of each class; ascending, as classes ascend in size */
    double edge[INDEX_CLASS_MAX]; /* wanted cell edge of each grid, length unit */
    bool fixed[INDEX_CLASS_MAX];  /* the user gave the edge: where cells are too many, go sparse at once */
    bool stencils;                /* search by a precomputed stencil a class instead of windows */
};

struct level {
    struct grid grid;
    struct cells owned, ghosts;
};

/* One search of the rows of a class. Lengths in frame units, rounded up. */
struct search {
    const struct level *level;
    const struct cells *cells;
    const struct stencil *stencil; /* NULL: windows */
    float margin;                  /* a candidate at distance <= (r + r_j + margin) may be a partner ... */
    float certain; /* ... and is one if distance^2 <= certain * that^2 (-infinity: never certain) */
    float reach;   /* r + reach bounds the distance of all partners in the table */
    bool half, home;
    bool single; /* rows are so large that each goes by itself */
    bool beyond; /* no candidate lies inside of the owned particles' extent */
    bool direct; /* rows look at the table where it lies (search_direct.h) */
};

enum {
    LEVELS_SEARCHES_MAX = 2 * INDEX_CLASS_MAX,
    LEVELS_CELLS_A_PARTICLE = 4, /* denser grids than this ... */
    LEVELS_CELLS_FREE = 4096,    /* ... and beyond this number of cells are kept sparse */
    LEVELS_PENCILS_DIRECT = 64,  /* large rows that meet more pencils leave out those beyond their reach */
};

/* What the rows of each class search. */
struct searches {
    int count[INDEX_CLASS_MAX];
    struct search (*list)[LEVELS_SEARCHES_MAX];
};

struct levels {
    struct levels_plan plan;
    struct frame frame;
    struct level level[INDEX_CLASS_MAX];
    struct members owned, ghosts;
    struct stencil stencil[INDEX_CLASS_MAX]; /* by class */
    struct searches searches;                /* at the visit */
    struct searches cross_searches;          /* at the build: of smaller owned particles by larger ones */
    struct cross_pairs cross;                /* what those found */
    uint32_t *slot_of;                       /* of owned particles, in their grid's table */
    size_t slot_capacity;
    struct cells_scratch scratch;
    struct cells order_cells; /* scratch of levels_order, where it does not keep its tables */
    bool kept;                /* the tables of owned particles lack nothing but their coordinates */
    bool ghosts_met;          /* by the last build: then none are kept */
    int instructions;         /* enum index_instructions, none of them INDEX_BEST */
    int cross_search;         /* enum index_cross */
    double radius_min[INDEX_CLASS_MAX], radius_max[INDEX_CLASS_MAX]; /* by grid, of the view's classes */
};

/* Smallest and largest cut-off, 2 radius_max + margin, of the classes first ... last; both 1 where none has a
 * size. */
struct levels_cutoffs {
    double smallest, largest;
};
struct levels_cutoffs levels_cutoffs(const struct index_view *view, int first, int last);

/* Cells of a grid with this edge in y and z over a volume (2D: an area), and whether these are so many for so
 * many particles that the grid is kept sparse. */
double levels_cells(double volume, double edge, int dimension);
bool levels_too_many_cells(double cells, double particles);

void levels_start(struct levels *levels, const struct index_params *params);
void levels_free(struct levels *levels);

/* The operations of the contract, for a plan made from the same view. */
void levels_order(struct levels *levels, const struct levels_plan *plan, const struct index_view *view,
                  uint32_t *order);
void levels_build(struct levels *levels, const struct levels_plan *plan, const struct index_view *view);
/* Emits what rows [first, last) find in these searches. Many threads at once. */
void levels_search(const struct levels *levels, const struct searches *searches,
                   const struct index_view *view, size_t first, size_t last, struct index_sink *sink);
void levels_visit(const struct levels *levels, const struct index_view *view, size_t first, size_t last,
                  struct index_sink *sink);
bool levels_check(const struct levels *levels, const struct index_view *view, char why[INDEX_WHY_MAX]);
void levels_describe(const struct levels *levels, struct index_description *description);
size_t levels_memory(const struct levels *levels);

#endif
