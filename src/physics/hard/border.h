/* SPDX-License-Identifier: BSD-3-Clause */
/* Bodies that several ranks hold: their velocities in a solve.
 *
 * A sweep over ranks has turns (problem.h). First each rank visits its contacts inside, those of bodies of its own, which no other
 * rank changes in this turn. Then come the contacts across, with copies of other ranks' bodies, those with higher ranks first: of a face
 * between two ranks one of them visits what it has, then the other. Where three ranks meet, the mass of a body that has
 * such contacts on several holders (its owner and copies) is split (Tonge et al., ACM Trans. Graph. 31 (2012) 105): a holder
 * with n of the N of this turn has the part w = n / (n + (N - n) / 4) of mass and inertia, and then the velocity changes by the sum of w
 * times what the holders did to it. Whatever the w are, momentum and impulses agree. With w = n / N each turn lessens the energy of
 * the problem: so it is in the rest of a step whose residual has grown. Larger parts converge faster, and for like spheres, whose
 * normals are 60 degrees apart, none of these is too large. Without copies there are no turns. */
#ifndef SCREE_HARD_BORDER_H
#define SCREE_HARD_BORDER_H

#include "kernel/comm/ghosts.h"
#include "physics/hard/problem.h"

struct hard_border {
    struct ghosts *ghosts; /* borrowed; NULL: one rank without copies */
    struct particles *particles;
    int field;              /* handle of six doubles a particle that travel: velocity and spin, or impulses */
    struct hard_body *last; /* of each particle: what all holders agreed on last */
    struct hard_share {
        double own[HARD_TURNS], all[HARD_TURNS]; /* contacts of this holder, of all, by turn */
        double lightness, swing;                 /* of the whole body */
    } * share;                                   /* of each particle */
    bool careful;                                /* in this step; the same on all ranks */
    size_t room;
};

void hard_border_free(struct hard_border *border);

/* Sends the velocities of owned bodies to their copies. Collective, as most functions below. */
void hard_border_send(struct hard_border *border, struct hard_problem *problem);

/* After all rows are known: finds their turns, and how many each body has. */
void hard_border_count(struct hard_border *border, struct hard_problem *problem, int rank);

/* Visits all rows by hard_problem_sweep or _rebound, in turns. */
void hard_border_turns(struct hard_border *border, struct hard_problem *problem,
                       void (*visit)(struct hard_problem *problem, enum hard_turn turn));

/* After the solve: sums the impulses on bodies without lightness, of which the originals then have all. Collective. */
void hard_border_gather(struct hard_border *border, const struct hard_problem *problem);

/* The sum of particle k, an original: impulse and its moment, six doubles. */
const double *hard_border_gathered(const struct hard_border *border, size_t k);

/* Six numbers of each particle: copies take those of their originals; originals add those of their copies. Collective. */
void hard_border_spread(struct hard_border *border, double (*value)[6]);
void hard_border_collect(struct hard_border *border, double (*value)[6]);

/* Joins what the holders have done to the velocities since the last exchange. */
void hard_border_join(struct hard_border *border, struct hard_problem *problem);

#endif
