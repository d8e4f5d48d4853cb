/* SPDX-License-Identifier: BSD-3-Clause */
/* How copies come to be: registered with their owner, and spread from neighbour to neighbour (Eibl and Ruede,
 * "A local parallel communication algorithm for polydisperse rigid body dynamics", Parallel Computing 80
 * (2018) 36-48), for ghosts.c.
 *
 * Round 1: the owner sends every copy that a place next to its subdomain needs. Where no ball reaches beyond
 * neighbours that is all, and is known to be all: next-neighbour synchronisation. Else those who got a copy
 * of a ball that reaches farther (a shadow) hand it on to places next to theirs, a round for each subdomain
 * that the reach crosses, until nobody has anything to hand on. A subdomain that a ball touches is reached:
 * the straight line from the centre to its nearest point runs through subdomains that the ball touches as
 * well, each next to the one before. So nobody need know more than who is next to him.
 *
 * Not created twice:
 *   - a rank remembers which shadows came (owner, number there, image) and passes each on once;
 *   - it leaves out places next to the one that the shadow came from: the sender has served those.
 * In the end every holder tells the owner what it holds from round 2 on, and the owner updates all holders
 * directly. A shadow ends at the next rebuild: holder and owner both know that, without a notice.
 *
 * Rounding: distances are the same bits wherever they are formed. A place that a ball misses by rounding
 * alone passes the ball on without keeping it (COPY_RELAY), as two images of one chain of subdomains may
 * round differently.
 *
 * The end of a round is told by one non-blocking reduction (exchange.h); nothing else is collective. */
#ifndef SCREE_COMM_SHADOWS_H
#define SCREE_COMM_SHADOWS_H

#include "comm/copies.h"
#include "comm/exchange.h"

/* A copy that this rank is to hold. */
struct shadow {
    int owner;
    uint32_t number; /* of the particle there */
    uint8_t image;
    const char *fields; /* its GHOST fields, packed, position not shifted */
};

struct shadows {
    /* What this rank holds: group g, from rank held.rank[g], has shadow[held.item[...]] */
    struct groups held;
    struct shadow *shadow;
    size_t count, room;
    /* What others hold of this rank's particles: group g, at rank kept.rank[g], has original[kept.item[...]],
     * in the order in which that rank has them */
    struct groups kept;
    uint32_t *original;
    int rounds;
    struct exchange_inbox *inbox; /* of each round: where `fields` point */
    int inboxes;
};

/* What a spread needs to know. All borrowed. */
struct shadows_place {
    struct exchange *exchange;
    const struct domain *domain;
    const struct box *box;
    struct particles *particles; /* the slot behind the owned ones is used as scratch */
    const double *reach;         /* [class] */
};

/* Sends the copies of round 1 and spreads what reaches farther. Collective. _free releases. */
void shadows_spread(struct shadows *shadows, const struct shadows_place *place, const struct copies *copies);
void shadows_free(struct shadows *shadows);

#endif
