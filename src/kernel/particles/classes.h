/* SPDX-License-Identifier: BSD-3-Clause */
/* Size classes: particles of like radius, whatever their material. A search, a ghost layer and a skin are
 * bounded per class pair, never by the largest radius of all.
 *
 * Classes are numbered from small to large: class c holds the radii in (cut[c-1], cut[c]]. Classes are the
 * same on every rank. If there are several kinds of particles, each kind has classes of its own, kind after
 * kind (kinds.h). The margin of a class pair is added to r_i + r_j: range (of the interactions) + skin. Walls
 * count as one more class, number `count`. Among kinds that do not move (classes_range.moving) the skin is
 * 0. */
#ifndef SCREE_PARTICLES_CLASSES_H
#define SCREE_PARTICLES_CLASSES_H

#include "base/error.h"
#include "index/index.h"
#include <stddef.h>
#include <stdint.h>

enum { CLASS_MAX = 32 };

/* How classes are chosen (scene key `classes`; kernel/pairs/classes_choose.h). */
enum classes_method { CLASSES_AUTO, CLASSES_ONE, CLASSES_CUTS, CLASSES_QUANTILES, CLASSES_GEOMETRIC };

struct classes_options {
    /* AUTO: as a search costs least (index/choose/auto_choose.h), and between sizes far apart. */
    enum classes_method method;
    int count;             /* QUANTILES and GEOMETRIC: how many, 1 ... CLASS_MAX */
    int cut_count;         /* CUTS: number of given cuts, 0 ... CLASS_MAX - 1 */
    double cut[CLASS_MAX]; /* CUTS: radii, increasing, length unit */
    bool skin_given;       /* true: `skin` is a length, the same for all class pairs */
    double skin;           /* length unit */
    double fraction;       /* AUTO: share of the space that the particles fill; 0: not known */
    int dimension;         /* AUTO: 2 or 3; 0: not known, 3 */
    double particles;      /* AUTO: number that the radii stand for; 0: as many as radii */
    double skin_relative;  /* else: skin of a pair = this x the smaller of the two classes' smallest radii */
    bool skin_auto;        /* the run changes the skin (engine/skin_auto.h); nothing here does */
    int kind;              /* AUTO: kind of the particles that have the radii (kinds.h) */
};

/* The ranges of the interactions. */
struct classes_range {
    /* The distance beyond touch within which two particles of these kinds and radii interact, length;
     * negative: only if the overlap is at least so much; -INFINITY: never. Symmetric, monotonic in each
     * radius. A wall has an infinite radius. NULL: 0. Any thread. */
    double (*of)(const void *context, int kind_a, double radius_a, int kind_b, double radius_b);
    const void *context;
    unsigned moving; /* bits 1 << kind of the kinds that move beside grains */
};

struct size_classes {
    int count;                    /* >= 1 */
    double cut[CLASS_MAX];        /* upper radius bound of each class; the last is >= every radius */
    double radius_min[CLASS_MAX]; /* smallest and largest radius present, over all ranks, length unit */
    double radius_max[CLASS_MAX];
    uint64_t population[CLASS_MAX]; /* particles in the class, over all ranks */
    uint8_t kind[CLASS_MAX];        /* kind of the particles of the class (kinds.h), in the order of places */
    double skin[CLASS_MAX + 1][CLASS_MAX + 1];   /* symmetric; row and column `count` are walls */
    double margin[CLASS_MAX + 1][CLASS_MAX + 1]; /* range + skin */
};

/* The defaults: CLASSES_AUTO, skin_relative 0.3. */
struct classes_options classes_options_default(void);

/* Recomputes skins and margins after radius_min or radius_max changed. */
void classes_set_margins(struct size_classes *classes, const struct classes_options *options,
                         const struct classes_range *range);

/* The range of two particles of these kinds and radii; `range` NULL: 0. */
double classes_range_at(const struct classes_range *range, int kind_a, double a, int kind_b, double b);

/* The range of a class pair: the largest of any two of their radii; -INFINITY where the two never interact. b
 * may be `count`, the walls. `range` NULL: 0. */
double classes_range_of(const struct size_classes *classes, const struct classes_range *range, int a, int b);

/* The class of a radius: the first c with radius <= cut[c] (the last class for anything larger). */
static inline int classes_of(const struct size_classes *classes, double radius) {
    int c = 0;
    while (c < classes->count - 1 && radius > classes->cut[c])
        c++;
    return c;
}

/* True if particles of the classes a and b may meet: their margin is not INDEX_NOT_WANTED. */
static inline bool classes_meet(const struct size_classes *classes, int a, int b) {
    return classes->margin[a][b] > INDEX_NOT_WANTED;
}

#endif
