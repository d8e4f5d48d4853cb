/* SPDX-License-Identifier: BSD-3-Clause */
/* Interactions: the pairs that interact, and their range. An interaction is a set of pairs to sum over:
 * contacts, the support of a kernel, a cohesive force with a range.
 *
 * All interactions of a scene share one index, one rebuild and one skin. The index finds the pairs that any
 * of them wants (interactions_range). An interaction has a pair list of its own if its range is clearly less
 * than that of all together (interaction_list); else it shares the list of all. A class pair that no
 * interaction wants is not searched.
 *
 * How to add an interaction:
 *   1. Write `range`: how far beyond touch two particles of these kinds and radii interact; -INFINITY where
 *      they never meet; a kernel of support h gives h - radius_a - radius_b. Its `context` are the options of
 *      the physics, its promises those of struct classes_range: symmetric, monotonic in each radius.
 *   2. Add a row to `interaction` of your physics, and count it in `interactions` (engine/physics.h). The pair
 *      list of row k is context->list[k], new after each rebuild. It has at least the pairs within the range
 *      and the skin: who walks over it tests the distance. `scree check SCENE` prints the interactions.
 *   3. Walk over the list (walk.h); where you need each pair in the rows of both particles, as a matrix does,
 *      make them by pair_rows_build.
 * src/physics/density/density.c is an example. */
#ifndef SCREE_PAIRS_INTERACTION_H
#define SCREE_PAIRS_INTERACTION_H

#include "kernel/pairs/pairlist.h"

enum { INTERACTIONS_MAX = 8 };

/* Plain data. */
struct interaction {
    const char *name; /* "contact" */
    /* See struct classes_range. */
    double (*range)(const void *context, int kind_a, double radius_a, int kind_b, double radius_b);
    const void *context;
};

/* The interactions of a scene and their pair lists. Rows are added before the first rebuild. */
struct interactions {
    int count;
    struct interaction row[INTERACTIONS_MAX];
    unsigned moving;      /* bits 1 << kind of the kinds that move beside grains (classes.h) */
    struct pairlist *all; /* the pairs that the index finds; owned */
    struct pairlist *own[INTERACTIONS_MAX];                /* NULL: the interaction shares `all`; owned */
    double margin[INTERACTIONS_MAX][CLASS_MAX][CLASS_MAX]; /* of each, skin included */
};

/* Adds a row; returns its number. */
int interactions_add(struct interactions *interactions, const struct interaction *row);

/* The range of all interactions together, for classes_choose and classes_set_margins; borrows
 * `interactions`. */
struct classes_range interactions_range(const struct interactions *interactions);

/* Makes the pair lists, empty. Free releases them. */
void interactions_create(struct interactions *interactions, const struct pairlist_options *options);
void interactions_free(struct interactions *interactions);

/* The list of an interaction; the pointer stays the same from the first interactions_divide on. */
struct pairlist *interaction_list(const struct interactions *interactions, int k);

/* Decides which interactions have a list of their own, once classes and margins are known: an interaction
 * that needs less than INTERACTION_SHARE of the space searched for all. Once a run, before the first
 * search. */
#define INTERACTION_SHARE 0.8
void interactions_divide(struct interactions *interactions, const struct size_classes *classes,
                         const struct pairlist_options *options);

/* Follows new skins of the classes: which interactions have lists of their own stays as it is. */
void interactions_set_margins(struct interactions *interactions, const struct size_classes *classes);

/* After `all` has been built for `view`: fills the lists of their own with the pairs that are near enough. Opens
 * its own team. */
void interactions_select(struct interactions *interactions, const struct size_classes *classes,
                         const struct index_view *view);

/* After the box has moved: the shifts of all lists follow. */
void interactions_follow(struct interactions *interactions, const struct box *box);

/* Releases the pairs of all lists (pairlist_release). */
void interactions_release(struct interactions *interactions);

/* Each pair in the rows of both its particles: row i has the partners partner[start[i]] ... [start[i + 1]), with
 * their image codes, in increasing order of particle number and code. For owned rows. All zero: empty. */
struct pair_rows {
    size_t rows, capacity, row_capacity;
    size_t *start;
    uint32_t *partner;
};

/* Makes the rows of a list that was built with newton off, where several ranks hold particles. The same rows for any
 * number of threads; opens its own team. */
void pair_rows_build(struct pair_rows *rows, const struct pairlist *list, size_t owned);
void pair_rows_free(struct pair_rows *rows);

#endif
