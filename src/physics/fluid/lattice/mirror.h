/* SPDX-License-Identifier: BSD-3-Clause */
/* Mirrors: the feet of fluid particles on the bodies of their wall neighbours, and the coefficients beta_ij =
 * d_j / d_i (weights.h). d_j is the depth of j behind the tangent plane of its own body at i's foot. */
#ifndef SCREE_LATTICE_MIRROR_H
#define SCREE_LATTICE_MIRROR_H

#include "physics/fluid/lattice/body_surfaces.h"

/* All borrowed. */
struct mirror_input {
    const struct weights_input *rows; /* the pairs must have grains near fluid particles */
    const int64_t *body;              /* of boundary particles, by particle number */
    const double (*spin)[4];          /* angular velocities, by particle number; NULL: none */
    double spacing, support;
    /* The foot of a place on a wall or an open side, by its number as a body (body_surfaces.h), with velocity and spin; NULL: none of
     * both. Any thread. */
    void (*wall)(const void *context, int64_t body, const double x[3], struct weights_foot *foot);
    const void *context;
};

/* A particle is behind a body if it lies deeper below the surface than this x spacing: nearer to the surface it counts
 * as one at WEIGHTS_NEAREST above. */
#define MIRROR_BEHIND 0.5

/* Fills mirror, wall_foot, foot, foot_start, opens, image and behind of weights that weights_make has made. Returns the number of
 * bodies within the support of a row whose grain was not found (a mistake of the program). Opens its own team. */
size_t mirror_make(struct weights *weights, const struct mirror_input *input);

/* Makes `turn` of the spins of the feet, once more where these have changed. Opens its own team. */
void mirror_turn(struct weights *weights, const struct weights_input *rows);

#endif
