/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes copies: the copies are registered with their owner, and spread from neighbour to neighbour (Eibl and
 * Ruede, "A local parallel communication algorithm for polydisperse rigid body dynamics", Parallel Computing
 * 80 (2018) 36-48), for ghosts.c.
 *
 * Round 1: the owner sends every copy that a place next to its subdomain needs. If no ball reaches beyond
 * neighbours, round 1 is enough, and all ranks know that: next-neighbour synchronisation. Else each rank that
 * got a copy of a ball that reaches farther (a shadow) hands the shadow on to places next to the rank's own,
 * one round for each subdomain that the reach crosses, until no rank has a shadow to hand on. Every subdomain
 * that a ball touches is reached: the straight line from the centre of the ball to the nearest point of the
 * subdomain runs through subdomains that the ball touches as well, each next to the one before. So a rank
 * needs to know only the places next to its own.
 *
 * No shadow is made twice:
 *   - a rank remembers the shadows received (owner, number at the owner, image) and passes each on once;
 *   - the rank leaves out places next to the sender's place: the sender has served those.
 * In the end every holder tells the owner which shadows the holder got from round 2 on, and the owner updates
 * all holders directly. A shadow ends at the next rebuild, without a message.
 *
 * Rounding: all ranks compute the same bits for a distance. A place that a ball misses only by rounding
 * passes the ball on without keeping the copy (COPY_RELAY), as two images of one chain of subdomains may
 * round differently.
 *
 * One non-blocking reduction (exchange.h) ends a round; no other operation is collective. */
#ifndef SCREE_COMM_SHADOWS_H
#define SCREE_COMM_SHADOWS_H

#include "kernel/comm/copies.h"
#include "kernel/comm/exchange.h"

/* A copy that this rank is to hold. */
struct shadow {
    int owner;
    uint32_t number; /* number of the particle at the owner */
    uint8_t image;
    const char *fields; /* its GHOST fields, packed, position not shifted */
};

struct shadows {
    /* Shadows that this rank holds: group g, from rank held.rank[g], has shadow[held.item[...]] */
    struct groups held;
    struct shadow *shadow;
    size_t count, room;
    /* Shadows of this rank's particles on other ranks: group g, at rank kept.rank[g], has
     * original[kept.item[...]], in the order of the shadows on that rank */
    struct groups kept;
    uint32_t *original;
    int rounds;
    struct exchange_inbox *inbox; /* the messages of each round; `fields` point into them */
    int inboxes;
};

/* Input of a spread. All borrowed. */
struct shadows_place {
    struct exchange *exchange;
    const struct domain *domain;
    const struct box *box;
    struct particles *particles; /* the slot behind the owned ones is used as scratch */
    const double *reach;         /* [class] */
};

/* Sends the copies of round 1 and spreads the balls that reach farther. Collective. _free releases. */
void shadows_spread(struct shadows *shadows, const struct shadows_place *place, const struct copies *copies);
void shadows_free(struct shadows *shadows);

#endif
