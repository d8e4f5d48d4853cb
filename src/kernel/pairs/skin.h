/* SPDX-License-Identifier: BSD-3-Clause */
/* When is a rebuild due? A pair list stays complete as long as the two largest displacements of each class
 * pair add up to no more than its skin. Moving walls count as one more class. Class pairs that are not wanted
 * (index.h) have no list, and so no skin.
 *
 * Exact displacements cost a pass over all particles, so a bound is kept instead: the largest possible
 * displacement of a class, the sum of its largest speed times dt. Only when the bound reaches the skin are
 * the displacements measured; the bound then falls back to the measured values.
 *
 * In a box that moves, displacements are those from the mean flow: a point that the flow carries has none,
 * whichever image of it is meant. The deformation F since the rebuild maps the vector d of a pair to F d + (u_j
 * - u_i), where u are these displacements. F shortens no vector by more than the part `nearing` of its length
 * (box_nearing), so a pair beyond cut-off c and skin s stays beyond c as long as
 *
 *     |u_i| + |u_j| + nearing (c + s) <= s. */
#ifndef SCREE_PAIRS_SKIN_H
#define SCREE_PAIRS_SKIN_H

#include "kernel/particles/particles.h"

struct skin {
    double bound[CLASS_MAX + 1];  /* no particle of the class has moved farther since the rebuild; the last
                                     entry is walls; length */
    double second[CLASS_MAX + 1]; /* the same for all but one particle of the class */
    double before[CLASS_MAX + 1]; /* bound before the last step */
    double growth[CLASS_MAX + 1]; /* of the bound in the last step */
    double (*anchor)[3];          /* position at the rebuild, owned particles */
    size_t capacity;
    bool anchored; /* the anchors are those of the last rebuild; else nobody can measure displacements */
    uint64_t rebuilds;
    unsigned moves;        /* drifts since the rebuild */
    const struct box *box; /* that moves; NULL: at rest */
    struct box then;       /* the box at the rebuild */
    double nearing;        /* part of a distance that the motion of the box has taken since the rebuild */
    double nearing_growth; /* in the last step */
};

struct skin *skin_create(void);
void skin_destroy(struct skin **skin);

/* Displacements are those from the mean flow of a box that moves; borrowed. */
void skin_follow(struct skin *skin, const struct box *box);

/* The squared speed of a particle relative to the mean flow where the particle was before its last drift over dt;
 * dt 0: where the particle is. Any thread. */
double skin_speed2(const struct box *box, const struct particle_state *state, double dt);

/* A rebuild has happened: displacements start from here. Opens its own thread team. With `steps` > 0 the next rebuild comes
 * after that many steps at the latest: positions are noted only if some class pair may use up its skin by then, should its bounds
 * grow twice as fast as in the last step. 0: they are noted. */
void skin_reset(struct skin *skin, const struct particles *particles, const struct size_classes *classes,
                double steps);

/* Releases the memory of positions, where nothing is expected to move. */
void skin_release(struct skin *skin);

/* The largest speed of each class in the drift just made (this rank's, or all ranks'), and how far walls have
 * moved in all. In a box that moves speeds are those of skin_speed2, and the box has moved. */
void skin_moved(struct skin *skin, const double *speed, int classes, double dt, double walls);

/* Replaces the bounds by the exact displacements of this rank's owned particles; leaves the bounds as they are where no positions
 * were noted. Opens its own thread team. */
void skin_measure(struct skin *skin, const struct particles *particles, int classes);

/* Ends the update of skin_moved, once the bounds are those of all ranks: stores the growth of each bound. */
void skin_settle(struct skin *skin, int classes);

/* True if some class pair may have used up its skin. */
bool skin_due(const struct skin *skin, const struct size_classes *classes);

/* True if some class pair has used up its skin beyond doubt, so that no measurement is needed: right after a
 * rebuild the bound of a class is the displacement of its fastest particle, and this displacement alone is
 * enough. */
bool skin_surely_due(const struct skin *skin, const struct size_classes *classes);

/* The largest part of its skin that a class pair has used up by the present bounds; more than 1: due. */
double skin_used(const struct skin *skin, const struct size_classes *classes);

/* True if one more step like the last is expected to use up the skin. */
bool skin_nearly_due(const struct skin *skin, const struct size_classes *classes);

#endif
