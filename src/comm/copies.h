/* SPDX-License-Identifier: BSD-3-Clause */
/* Which ranks need a copy of which particle, for ghosts.c.
 *
 * Rank q computes the pairs that are at home there. With newton on, the home of a pair is its smaller
 * particle (index_pair_home): so p, as the larger one, must be known wherever a particle of its own or a
 * smaller class may lie within reach, and nowhere else. With newton off, or with full ghosts, all classes
 * count. Hence q needs p under an image iff
 *
 *     dist(x_p + image, subdomain of q) <= r_p + reach(class of p),
 *     reach(a) = max over the classes c that count and are wanted of (radius_max(c) + margin(a, c)).
 *
 * Distances are to the cuboid, not to its bounding box of any kind. The bound is widened by a few units in
 * the last place, because r_p + (r_c + margin) and the pair's (r_p + r_c) + margin may differ by that much.
 *
 * Here an owner finds the copies for places next to its subdomain, and which balls reach beyond those (far):
 * these spread from neighbour to neighbour (shadows.h), or are refused. */
#ifndef SCREE_COMM_COPIES_H
#define SCREE_COMM_COPIES_H

#include "comm/domain.h"
#include "comm/groups.h"
#include "particles/fields.h"

/* How far beyond its own surface a particle of each class must be known; -infinity: nowhere, as it meets
 * nobody. */
void copies_reach(const struct size_classes *classes, bool reduced, double reach[CLASS_MAX]);

/* A particle as far as it must be known. */
struct copy_ball {
    const double *x;
    double radius; /* a place needs a copy up to this distance */
    double relay;  /* a place up to this distance passes it on: more by what rounding may hide */
};
void copies_ball(struct copy_ball *ball, const struct particle_state *state, double reach,
                 const struct box *box);

/* A copy of a ball that may reach beyond the neighbours of its owner; a copy that is passed on and not kept.
 */
enum { COPY_FAR = 1, COPY_RELAY = 2 };

/* Copies to send: record k is a copy of the owned particle particle[k] under the image code image[k]; sorted
 * by rank (groups), then by particle. */
struct copies {
    struct groups groups; /* of records, in their order: item[k] == k */
    uint32_t *particle;
    uint8_t *image, *how;
    bool far;        /* some ball may reach beyond the neighbours */
    size_t farthest; /* the one of these with the largest radius */
    double radius;   /* that radius */
};

/* Finds the copies of all owned particles for places next to the own subdomain. A copy that would stand where
 * its original does is none. Opens its own thread team; the result does not depend on its size. _free
 * releases. */
void copies_select(struct copies *copies, const struct comm *comm, const struct domain *domain,
                   const struct box *box, const struct particles *particles, const double reach[CLASS_MAX]);
void copies_free(struct copies *copies);

/* fields_pack by several threads where the list is long enough. */
void copies_pack(const struct particles *particles, const struct field_list *fields, const uint32_t *list,
                 size_t n, char *buffer);

#endif
