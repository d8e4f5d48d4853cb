/* SPDX-License-Identifier: BSD-3-Clause */
/* The parts of a set of grids; levels.h has the functions, and the table of the searches of rows. For the
 * files of the grids and the search, and for tests. */
#ifndef SCREE_INDEX_GRIDS_LEVELS_PARTS_H
#define SCREE_INDEX_GRIDS_LEVELS_PARTS_H

#include "index/grids/cells.h"
#include "index/grids/cross.h"
#include "index/grids/grid.h"
#include "index/grids/stencil.h"

/* The grids that an index chooses. */
struct levels_plan {
    int grids;
    int grid_of[INDEX_CLASS_MAX]; /* of each class; ascending, as classes ascend in size */
    double edge[INDEX_CLASS_MAX]; /* wanted cell edge of each grid, length unit */
    bool fixed[INDEX_CLASS_MAX];  /* the user gave the edge: with too many cells, go sparse at once */
    bool idle[INDEX_CLASS_MAX];   /* the grid's class has no partners: no cells (levels_plan_apart) */
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
    bool single; /* rows are so large that each is searched by itself */
    bool beyond; /* no candidate lies inside of the frame's hollow */
    bool direct; /* rows read the table without a buffer (search_direct.h) */
};

enum {
    LEVELS_SEARCHES_MAX = 2 * INDEX_CLASS_MAX,
    LEVELS_CELLS_A_PARTICLE = 4, /* denser grids than this ... */
    LEVELS_CELLS_FREE = 4096,    /* ... and beyond this number of cells are kept sparse */
    LEVELS_PENCILS_DIRECT = 64,  /* large rows that meet more pencils leave out those beyond their reach */
};

/* The searches of the rows of each class. */
struct searches {
    int count[INDEX_CLASS_MAX];
    struct search (*list)[LEVELS_SEARCHES_MAX];
};

/* Whether the particles lie in the order of their slots, and how long they have. */
struct levels_stay {
    bool sorted;    /* after a build: in the order of the slots, cells that searches may read after moves */
    bool due;       /* the particles stay where they are; the build keeps the cells */
    int builds;     /* since the order */
    double edge[3]; /* of the box, at the order */
    double growth,
        owing;     /* of the searched volume, as a share of it: in the last build, and all builds together */
    uint8_t *turn; /* of each particle: code of the image near its cell; 0 of a ghost */
    bool turned;   /* some code is not 0 */
    size_t capacity;
};

struct levels {
    struct levels_plan plan;
    struct frame frame;
    struct level level[INDEX_CLASS_MAX];
    struct members owned, ghosts;
    struct stencil stencil[INDEX_CLASS_MAX]; /* by class */
    struct searches searches;                /* at the visit */
    struct searches cross_searches;          /* at the build: of smaller owned particles by larger ones */
    struct cross_pairs cross;                /* pairs found by cross_searches */
    uint32_t *slot_of;                       /* of owned particles, in their grid's table */
    size_t slot_capacity;
    struct cells_scratch scratch;
    struct cells order_cells; /* scratch of levels_order, where it does not keep its tables */
    bool kept;                /* the tables of owned particles are complete except for the coordinates */
    struct levels_stay stay;  /* particles that stay in their slots (levels_stay.c) */
    int instructions;         /* enum index_instructions, none of them INDEX_BEST */
    int cross_search;         /* enum index_cross */
    double radius_min[INDEX_CLASS_MAX], radius_max[INDEX_CLASS_MAX]; /* by grid, of the view's classes */
};

/* Particles to frame coordinates, and these to cells, a batch at a time: plain loops over small arrays, which
 * compilers turn into vector instructions. The results are those of grid_frame_coordinate and grid_cell to the
 * last bit. */

enum { LOCATE_BATCH = 128 };

struct located {
    size_t count;
    float x[3][LOCATE_BATCH]; /* frame coordinates */
    double r[LOCATE_BATCH];   /* radii, length unit */
    uint32_t cell[3][LOCATE_BATCH];
    bool clamped; /* the frame clamped some coordinate */
};

/* Coordinates and radii of `count` <= LOCATE_BATCH particles: those listed, or (NULL) first, first + 1 ... */
void locate_particles(struct located *located, const struct index_view *view, const struct frame *frame,
                      const uint32_t *list, size_t first);

/* The cells of the located particles. */
void locate_cells(struct located *located, const struct grid *grid);

#endif
