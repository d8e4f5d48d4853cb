/* SPDX-License-Identifier: BSD-3-Clause */
/* When is a rebuild due? A pair list stays complete as long as the two largest displacements of each class
 * pair add up to no more than its skin. Moving walls count as one more class. Class pairs that are not wanted
 * (index.h) have no list, and so no skin.
 *
 * Exact displacements cost a pass over all particles, so a bound is kept instead: the largest possible
 * displacement of a class, the sum of its largest speed times dt. Only when the bound reaches the skin are
 * the displacements measured; the bound then falls back to the measured values. */
#ifndef SCREE_PAIRS_SKIN_H
#define SCREE_PAIRS_SKIN_H

#include "particles/particles.h"

struct skin {
    double bound[CLASS_MAX + 1];  /* no particle of the class has moved farther since the rebuild; the last
                                     entry is walls; length */
    double second[CLASS_MAX + 1]; /* the same for all but one particle of the class */
    double before[CLASS_MAX + 1]; /* bound before the last step */
    double growth[CLASS_MAX + 1]; /* of the bound in the last step */
    double (*anchor)[3];          /* position at the rebuild, owned particles */
    size_t capacity;
    uint64_t rebuilds;
    unsigned moves; /* drifts since the rebuild */
};

struct skin *skin_create(void);
void skin_destroy(struct skin **skin);

/* A rebuild has happened: displacements start from here. Opens its own thread team. */
void skin_reset(struct skin *skin, const struct particles *particles);

/* The largest speed of each class in the drift just made (this rank's, or all ranks'), and how far walls have
 * moved in all. */
void skin_moved(struct skin *skin, const double *speed, int classes, double dt, double walls);

/* Replaces the bounds by the exact displacements of this rank's owned particles. Opens its own thread team.
 */
void skin_measure(struct skin *skin, const struct particles *particles, int classes);

/* Ends the update of skin_moved, once the bounds are those of all ranks: stores the growth of each bound. */
void skin_settle(struct skin *skin, int classes);

/* True if some class pair may have used up its skin. */
bool skin_due(const struct skin *skin, const struct size_classes *classes);

/* True if some class pair has used up its skin beyond doubt, so that no measurement is needed: right after a
 * rebuild the bound of a class is the displacement of its fastest particle, and this displacement alone is
 * enough. */
bool skin_surely_due(const struct skin *skin, const struct size_classes *classes);

/* True if one more step like the last is expected to use up the skin. */
bool skin_nearly_due(const struct skin *skin, const struct size_classes *classes);

#endif
