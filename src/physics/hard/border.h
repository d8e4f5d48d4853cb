/* SPDX-License-Identifier: BSD-3-Clause */
/* Bodies that several ranks hold: their velocities in a solve.
 *
 * The mass of a body whose contacts lie on k holders (its owner and copies) is split: each holder has 1/k of mass and
 * inertia, and after each sweep the velocity is the mean of the k. This converges always, at the price of more sweeps
 * (mass splitting). Without copies nothing happens. */
#ifndef SCREE_HARD_BORDER_H
#define SCREE_HARD_BORDER_H

#include "kernel/comm/ghosts.h"
#include "physics/hard/problem.h"

struct hard_border {
    struct ghosts *ghosts; /* borrowed; NULL: one rank without copies */
    struct particles *particles;
    int field;              /* handle of six doubles a particle that travel: velocity and spin, or impulses */
    struct hard_body *last; /* of each particle: what all holders agreed on last */
    double *holders;        /* of each particle, 1 at least */
    size_t room;
};

void hard_border_free(struct hard_border *border);

/* Sends the velocities of owned bodies to their copies. Collective, as most functions below. */
void hard_border_send(struct hard_border *border, struct hard_problem *problem);

/* After all rows are known: counts the holders. `split`: the masses of the bodies are split; else they are whole again. */
void hard_border_count(struct hard_border *border, const struct hard_problem *problem);
void hard_border_split(const struct hard_border *border, struct hard_problem *problem, bool split);

/* After the solve: sums the impulses on bodies without lightness, of which the originals then have all. Collective. */
void hard_border_gather(struct hard_border *border, const struct hard_problem *problem);

/* The sum of particle k, an original: impulse and its moment, six doubles. */
const double *hard_border_gathered(const struct hard_border *border, size_t k);

/* Six numbers of each particle: copies take those of their originals; originals add those of their copies. Collective. */
void hard_border_spread(struct hard_border *border, double (*value)[6]);
void hard_border_collect(struct hard_border *border, double (*value)[6]);

/* Joins what the holders have done to the velocities since the last exchange: their sum, or their mean where the masses
 * are split. */
void hard_border_join(struct hard_border *border, struct hard_problem *problem, bool split);

#endif
