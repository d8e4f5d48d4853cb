/* SPDX-License-Identifier: BSD-3-Clause */
/* The spatial index: its input is positions and radii, its output is pairs. This is the contract.
 *
 * A pair is (i, j, image): i an owned particle, j an owned one or a ghost, with
 *     | x_j + shift(image) - x_i |  <=  r_i + r_j + margin(class i, class j)       (index_view.margin)
 * Particles of two classes whose margin is INDEX_NOT_WANTED never meet, however near: no index emits such a
 * pair, and none searches for it, as far as its cells keep the classes apart (index_wanted). A class may be
 * unwanted with itself; a class without any partner class costs an index nothing. Particles of one rigid body
 * (index_view.body) never meet either: index_visit drops their pairs, so that no index need know of bodies.
 * The index itself wraps directions that are periodic *in the view*, and then names the image of j; in all
 * other directions the image is 0, and the view has the copies (ghosts) that are needed. Because the image is
 * explicit, boxes thinner than two cut-offs and particles larger than half a box work: the same i and j may
 * meet through two images. A particle never pairs with itself (the caller guarantees for wanted pairs that
 * r_i + r_j + margin < edge).
 * In directions that are periodic in the view, positions lie in [0, edge] (rounding apart: a millionth of an
 * edge is tolerated). A particle of a higher class is larger than every particle of a lower one.
 *
 * Which pairs a rank keeps:
 *   both owned            once, as (i, j) or (j, i); the index chooses the row
 *   i owned, j a ghost    newton off: always. newton on: iff i is the pair's *home* (index_pair_home)
 *   both ghosts           never
 * The set is the same for every index, every thread count and every order of the particles.
 *
 * The operations, their callers and times, and the data that they change:
 *   operation    called                              may touch                    threads
 *   applicable   before create, by `auto` and tests  nothing                      one
 *   create       once a run, or on a switch          its own state                one
 *   stays        at a rebuild, before order          its own state                one
 *   order        at a rebuild, before build, with    its own scratch              opens its team
 *                owned particles only (total = owned)
 *   build        at a rebuild                        its own state; keeps no      opens its team
 *                                                    pointer into the view
 *   visit        by pair lists, to count and to fill its state read-only;         many at once
 *                                                    the thread's own sink
 *   check        tests                               nothing                      one
 *   describe     start of a run, `scree check`       nothing                      one
 *   memory       the report                          nothing                      one
 *   trials       after a build                       nothing                      one
 *   select       before order                        its own state                one
 *   release      after the visits, where nothing      its own state                one
 *                moves: memory is freed
 *   destroy      once                                its own state                one
 *
 * How to add an index, in six steps:
 *   1. Copy index/methods/brute.c to index/methods/NAME.c: it is the oracle of every test and the shortest example. An index
 *      on grids is a plan for the body that they share: index/methods/linkcell.c.
 *   2. Put your state into a struct whose first member is `struct index base`; the build makes it, from all
 *      particles, copies included.
 *   3. Fill one `const struct index_ops NAME_ops` with designated initialisers, no casts. `applicable`,
 *      `stays`, `order`, `check`, `trials` and `select` may be NULL, as in brute; the tests want a `check` of every
 *      index but brute. An index without cells describes no levels.
 *   4. Declare it in index/methods/registry.c, and add one entry at the end of its table. No other file of the
 *      program knows the name; tests/app take the names from `scree help index.name`.
 *   5. Add the file to index/local.mk. tests/index/test_index, test_levels and test_wanted compare every
 *      registered index with `brute`, tests/app/density.sh does so on several ranks.
 *   6. Describe it in docs/indexes.md and README.md; `make pages` writes docs/scene.md.
 *
 * Only index.c calls through the table; all other files use the wrappers below, which check, count and time.
 */
#ifndef SCREE_INDEX_INDEX_H
#define SCREE_INDEX_INDEX_H

#include "base/error.h"
#include "base/image.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum { INDEX_CLASS_MAX = 32, INDEX_WHY_MAX = 512 };

/* The margin of two classes whose particles never meet. */
#define INDEX_NOT_WANTED (-INFINITY)

/* Bounds of ghosts in open directions. Ghosts beyond cost time, and nothing else. */
struct index_around {
    bool known;
    double low[3], high[3]; /* infinite: not known at this end */
};

/* Read-only view of the particles. The index owns nothing of it. */
struct index_view {
    size_t owned, total;       /* owned particles first, then ghosts up to total */
    const double *position;    /* x y z of particle k at position[k * stride] ... [k * stride + 2] */
    const double *radius;      /* radius of particle k at radius[k * stride] */
    size_t stride;             /* doubles from one particle to the next */
    const uint8_t *size_class; /* class of particle k, 0 ... classes-1, from small to large */
    const int64_t *body;       /* particles of one body, a number >= 0, never meet; NULL: no bodies */
    const int64_t *id;         /* global ids; only ghost pairs of equal radius need them (index_pair_home) */
    int dimension;             /* 2 or 3; in 2D all z are equal */
    double edge[3];            /* box edges; the box's lower corner is the origin */
    bool periodic[3];          /* directions that the index must wrap. Elsewhere particles may lie anywhere */
    bool newton;
    int classes;                                     /* number of size classes */
    double radius_max[INDEX_CLASS_MAX];              /* largest radius a particle of the class may have */
    double margin[INDEX_CLASS_MAX][INDEX_CLASS_MAX]; /* added to r_i + r_j, or INDEX_NOT_WANTED; symmetric */
    int threads;                                     /* size of the team that build and order may open */
    bool ordered; /* at build: the owned particles are those of the last `order`, now in that order, and none
                     has moved; or `stays` was true, and they are those of the last build. The index may then
                     use what it has; the pairs are the same */
    struct index_around around; /* at order: where the ghosts will be */
};

/* True if particles of the classes a and b may meet. */
static inline bool index_wanted(const struct index_view *view, int a, int b) {
    return view->margin[a][b] > INDEX_NOT_WANTED;
}

/* Options of an index that the user may set (scene key `index`). Zero or negative means: the index's
 * default. */
struct index_params {
    /* Cell edge as a multiple of the cut-off that the index builds on; 0: its own default. */
    double cell_factor;
    int levels; /* hgrid: number of levels, each a run of neighbouring classes; 0: one level for each class */
    double level_cell[INDEX_CLASS_MAX]; /* hgrid: cell edge of each level, length unit; 0: cell_factor x the
                                           level's cut-off */
    int cross_search;                   /* searching side in pairs of unlike levels: an enum index_cross */
    int instructions; /* vector instructions that the search uses: an enum index_instructions */
};

/* INDEX_BEST takes the widest instructions of the CPU. If the CPU lacks the chosen ones, the search takes the
 * widest of the CPU. The pairs are the same. */
enum index_instructions { INDEX_BEST, INDEX_PLAIN, INDEX_AVX2, INDEX_AVX512 };

/* Pairs of unlike levels are found by the smaller particle among the larger ones, by the larger among the
 * smaller, or in whichever of the two ways costs less. The pairs are the same. */
enum index_cross { INDEX_CROSS_AUTO, INDEX_CROSS_SMALLER, INDEX_CROSS_LARGER };

/* Receives pairs. The index writes pair k to i[k], j[k] while k < capacity, and counts on beyond; a sink with
 * capacity 0 only counts. j carries the code of the image that is added to j (base/image.h) in its upper 5
 * bits: j | code << 27. The index may overwrite the arrays up to INDEX_SINK_PAD entries beyond `count`, if
 * within capacity: the owner of the arrays allocates capacity + INDEX_SINK_PAD. */
struct index_sink {
    uint32_t *i, *j;
    size_t count, capacity;
};
enum { INDEX_SINK_PAD = 32, INDEX_IMAGE_SHIFT = 27 };

/* The home of a pair: the particle whose owner computes the pair with newton on. The home is the particle of
 * smaller radius; for equal radii the two ids give a fixed choice, which spreads the work over both owners.
 * True if i is the home. Symmetric: exactly one of (i,j), (j,i). */
static inline bool index_pair_home(double radius_i, int64_t id_i, double radius_j, int64_t id_j) {
    if (radius_i != radius_j)
        return radius_i < radius_j;
    return ((id_i + id_j) & 1) ? id_i < id_j : id_i > id_j;
}

/* Emits one pair. For indexes that find pairs one by one; vectorised indexes write runs of pairs
 * themselves. */
static inline void index_sink_put(struct index_sink *sink, uint32_t i, uint32_t j, unsigned code) {
    if (sink->count < sink->capacity) {
        sink->i[sink->count] = i;
        sink->j[sink->count] = j | code << INDEX_IMAGE_SHIFT;
    }
    sink->count++;
}

/* One line of the level table of the report. */
struct index_level {
    double cell;                   /* cell edge, length unit; 0: no cells, as there are no partners */
    double radius_min, radius_max; /* radii of the classes on this level */
    size_t cells;                  /* cells allocated (dense) or occupied (sparse) */
    size_t particles;              /* owned particles and ghosts on the level */
    bool sparse;
};

struct index_description {
    int levels; /* 0: an index without cells */
    struct index_level level[INDEX_CLASS_MAX];
    /* of an index that chooses (`auto`); else empty */
    char choice[16];         /* the index that the choice amounts to */
    char why[INDEX_WHY_MAX]; /* one line: the parts of the predicted cost */
    double predicted;        /* seconds a rebuild: order, build and visit */
    uint64_t choices;        /* how often the index chose: more than once if the scene changed */
    int variant;             /* variant of the choice, selected after trials; 0: the predicted best */
};

struct index;

struct index_ops {
    const char *name;    /* value of the scene key index.name */
    const char *summary; /* one line for `scree help index.name` */
    /* True if this index can serve the view; else `why` gets one line (too many cells ...). */
    bool (*applicable)(const struct index_params *params, const struct index_view *view,
                       char why[INDEX_WHY_MAX]);
    struct index *(*create)(const struct index_params *params);
    void (*destroy)(struct index *self);
    /* True if the owned particles, those of the last build in the same order and with the same classes, may
     * stay where they are, however far they have moved, and this is likely to cost less than an order. Then no
     * `order` comes before the build. NULL: false, or true for an index without order. */
    bool (*stays)(struct index *self, const struct index_view *view);
    /* The particle order in which a search runs through memory: new particle k = old order[k]; classes one
     * after another, from small to large. order[view->owned] is the caller's. Stable: particles of one cell
     * keep their order. NULL: the order stays. */
    void (*order)(struct index *self, const struct index_view *view, uint32_t *order);
    void (*build)(struct index *self, const struct index_view *view);
    /* Emits every kept pair whose row (first) particle lies in [first, last); rows are owned particles. Any
     * partition of [0, owned) into ranges gives each pair once. The view is the one of the last build,
     * unchanged. */
    void (*visit)(const struct index *self, const struct index_view *view, size_t first, size_t last,
                  struct index_sink *sink);
    /* False, with one line in `why`, if the state does not fit the view: if a particle moved since the build,
     * say. */
    bool (*check)(const struct index *self, const struct index_view *view, char why[INDEX_WHY_MAX]);
    void (*describe)(const struct index *self, struct index_description *description);
    size_t (*memory)(const struct index *self); /* bytes held */
    /* For an index that chooses, else NULL. trials: the number of variants of its choice that are worth
     * timing; select: takes the k-th variant from the next order on. A new choice starts with variant 0
     * again. */
    int (*trials)(const struct index *self);
    void (*select)(struct index *self, int variant);
    /* Frees the memory of the last build; `build` comes before the next visit. NULL: it keeps the memory. */
    void (*release)(struct index *self);
};

/* The base of every index: first member of its private struct. */
struct index {
    const struct index_ops *ops;
    struct index_params params;
    uint64_t builds;
    double order_seconds, build_seconds; /* wall time spent so far */
    struct index_description *described; /* by index_release, of the build that was released; NULL: none */
};

/* The number of registered indexes; the k-th index; the index of a name, or NULL. `brute` is the first. */
int index_registry_count(void);
const struct index_ops *index_registry_get(int k);
const struct index_ops *index_registry_find(const char *name);

/* Creates the index of a name. An unknown name is a user's error, and the message lists the known names.
 * Destroy frees the index and sets the pointer to NULL. */
struct index *index_create(const char *name, const struct index_params *params, struct error *error);
void index_destroy(struct index **index);

/* The wrappers of the operations above. */
bool index_applicable(const char *name, const struct index_params *params, const struct index_view *view,
                      char why[INDEX_WHY_MAX]);
bool index_stays(struct index *index, const struct index_view *view);
void index_order(struct index *index, const struct index_view *view, uint32_t *order);
void index_build(struct index *index, const struct index_view *view);
void index_visit(const struct index *index, const struct index_view *view, size_t first, size_t last,
                 struct index_sink *sink);
bool index_check(const struct index *index, const struct index_view *view, char why[INDEX_WHY_MAX]);
void index_describe(const struct index *index, struct index_description *description);
size_t index_memory(const struct index *index);
int index_trials(const struct index *index); /* 0: nothing to try */
void index_select(struct index *index, int variant);
void index_release(struct index *index); /* index_describe goes on to describe the build that was released */

#endif
