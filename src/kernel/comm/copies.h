/* SPDX-License-Identifier: BSD-3-Clause */
/* The copies of particles that other ranks need, for ghosts.c.
 *
 * Rank q computes the pairs whose home particle q owns. With newton on, the home of a pair is the smaller
 * particle (index_pair_home). A rank therefore needs the larger particle p only if the rank may own a
 * particle of the same or a smaller class within reach of p. With newton off, or with full ghosts, all
 * classes count. Hence q needs p under an image iff
 *
 *     dist(x_p + image, subdomain of q) <= r_p + reach(class of p),
 *     reach(a) = max over the classes c that count and are wanted of (radius_max(c) + margin(a, c)).
 *
 * Distances are to the cuboid itself, not to a larger bounding shape. The bound is widened by a few units in
 * the last place, because r_p + (r_c + margin) and the pair's (r_p + r_c) + margin may differ by that much.
 *
 * Here an owner finds the copies for places next to its subdomain, and the balls that reach beyond these
 * places (far). Far balls spread from neighbour to neighbour (shadows.h), or are refused. */
#ifndef SCREE_COMM_COPIES_H
#define SCREE_COMM_COPIES_H

#include "kernel/comm/domain.h"
#include "kernel/comm/rank_groups.h"
#include "kernel/particles/fields.h"

/* The distance beyond a particle's surface within which ranks need the particle, for each class; -infinity:
 * no rank needs particles of the class, as they meet no partner. */
void copies_reach(const struct size_classes *classes, bool reduced, double reach[CLASS_MAX]);

/* A particle as a ball: the region in which ranks need a copy of the particle. `own`: its own reach, 0: none. */
struct copy_ball {
    const double *x;
    double radius; /* a place needs a copy up to this distance */
    double relay;  /* a place up to this distance passes the copy on: `radius` and the rounding error */
};
void copies_ball(struct copy_ball *ball, const struct particle_state *state, double reach, double own,
                 const struct box *box);

/* The field of particles that other ranks must know beyond the reach of their class: `own`, the distance from
 * the centre up to which they must (0: no farther than the class). Whoever registers it sets it before each
 * migration. copies_own_reach is NULL where nobody has. */
void copies_register_reach(struct particles *particles);
double *copies_own_reach(const struct particles *particles);

/* COPY_FAR: a copy of a ball that may reach beyond the neighbours of the ball's owner. COPY_RELAY: a copy
 * that is passed on and not kept. */
enum { COPY_FAR = 1, COPY_RELAY = 2 };

/* Copies to send: record k is a copy of the owned particle particle[k] under the image code image[k]; sorted
 * by rank (groups), then by particle. */
struct copies {
    struct groups groups; /* the records in their order: item[k] == k */
    uint32_t *particle;
    uint8_t *image, *how;
    bool far;        /* some ball may reach beyond the neighbours */
    size_t farthest; /* the far ball with the largest radius */
    double radius;   /* radius of the farthest ball */
};

/* Finds the copies of all owned particles for places next to the own subdomain. A copy at the very position
 * of its original is left out. The function opens its own team of threads; the result does not depend on the
 * size of the team. _free releases. */
void copies_select(struct copies *copies, const struct comm *comm, const struct domain *domain,
                   const struct box *box, const struct particles *particles, const double reach[CLASS_MAX]);
void copies_free(struct copies *copies);

/* As fields_pack, by several threads if the list is long enough. */
void copies_pack(const struct particles *particles, const struct field_list *fields, const uint32_t *list,
                 size_t n, char *buffer);

#endif
