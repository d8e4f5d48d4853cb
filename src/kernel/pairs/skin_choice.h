/* SPDX-License-Identifier: BSD-3-Clause */
/* Chooses the skin of a run by a model of its cost. A longer skin lets more steps pass until the next rebuild,
 * and puts more pairs into the list, which each step filters and each rebuild finds. The model counts work, it
 * measures no time: the choice is then the same in each run of a scene, on any machine, and in a run that
 * resumes.
 *
 * The skins of all class pairs are those of the scene (kernel/particles/classes.h) times one factor f. In units of
 * the filter of one pair, a step costs
 *
 *     c(f) = p(f) + (SKIN_PARTICLE n + SKIN_PAIR p(f)) / k(f),    k(f) = f / rate.
 *
 * n particles have p(f) pairs in the list, and k(f) steps lie between two rebuilds. `rate` is the part of the
 * scene's skin that the displacements use up in a step, as measured over the last rebuilds. Of the pairs, those
 * that touch are there with any skin; the number of the other pairs grows with the volume of the shells
 * beyond touch, class pair by class pair. */
#ifndef SCREE_PAIRS_SKIN_CHOICE_H
#define SCREE_PAIRS_SKIN_CHOICE_H

#include "kernel/particles/classes.h"

/* Prices of a rebuild for a particle and for a pair of the list, in those of a pair in the filter: 50 and 5 by counts of
 * instructions; a rebuild waits for memory more often than a filter does. */
enum { SKIN_PARTICLE = 60, SKIN_PAIR = 12 };

/* The factors are quarters of octaves; one choice changes the factor by an octave at most. A change must save a
 * part of the cost. The list has room for so many pairs a particle, unless the skin of the scene needs more. */
enum { SKIN_LEAST = -16, SKIN_MOST = 12, SKIN_LEAP = 4, SKIN_PAIRS_MOST = 24 };

/* Counts over all ranks. Lists with the sides of pairs on two ranks count halves. */
struct skin_counts {
    double particles, pairs;
    double contacts; /* pairs of the list that touch; 0: not known */
    double rate;     /* see above; in units of the scene's skin, not of the present one */
    double every;    /* steps after which a rebuild comes in any case; 0: none */
    int dimension;   /* 2 or 3 */
};

/* The state of a choice: what a resume needs. */
struct skin_choice {
    int64_t octaves; /* factor = 2^(octaves / 4) */
    double used,
        steps; /* displacements in units of the scene's skin, and the steps that they took; both fade */
    uint64_t changes;
};

/* 2^(octaves / 4). */
double skin_choice_factor(int64_t octaves);

/* Adds an interval between two rebuilds: displacements used up the part `used` of the scene's skin in `steps`
 * steps. Older intervals fade. */
void skin_choice_add(struct skin_choice *choice, double used, double steps);

/* The cost of a step at `octaves`, where the counts are those with the skins of `classes`, which are those at
 * the factor of `now`. */
double skin_choice_cost(const struct size_classes *classes, const struct skin_counts *counts, int64_t now,
                        int64_t octaves);

/* The pairs of the list at `octaves`, by the same model. */
double skin_choice_pairs(const struct size_classes *classes, const struct skin_counts *counts, int64_t now,
                         int64_t octaves);

/* The best factor up to `most`: within a leap of `now`, and `now` itself unless another is clearly better or
 * `now` is above `most`. */
int64_t skin_choice_best(const struct size_classes *classes, const struct skin_counts *counts, int64_t now,
                         int64_t most);

#endif
