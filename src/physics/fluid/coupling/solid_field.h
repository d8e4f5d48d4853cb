/* SPDX-License-Identifier: BSD-3-Clause */
/* The part of each node of a fixed lattice that grains fill, where the fluid fills the whole box, grains included
 * (`fluid.grains: {coupling: rigid}`). The surface of a grain is that of `fluid.grains.hydraulic` times its radius. A body (rigid_bodies.h) has the largest phi of its members. With the signed distance d of a node from the surface of grain i, negative inside,
 *
 *   phi_i = (1 - sin(pi s / 2)) / 2,   s = d / (SOLID_EDGE spacing), cut to -1 ... 1;   Phi = min(1, sum of phi_i)
 *
 * is the field `solid`; walls that move through the fluid are among the grains (rigid_walls.h). The flow is made rigid by the gain g = Phi / (Phi + kappa (1 - Phi)), which the grains share by their phi: 1 inside, in the edge a
 * drag of Darcy with the time kappa dt (1 - Phi) / Phi. So kappa = SOLID_DARCY spacing^2 / (nu dt), at most SOLID_KAPPA_MOST, makes drag independent of the step. */
#ifndef SCREE_COUPLING_SOLID_FIELD_H
#define SCREE_COUPLING_SOLID_FIELD_H

#include "engine/physics.h"
#include "kernel/pairs/interaction.h"
#include "physics/grains/walls/wall_options.h"

#define SOLID_EDGE 1.0
#define SOLID_DARCY 0.1
#define SOLID_KAPPA_MOST 8.0

/* A node in the reach of a grain. */
struct solid_part {
    uint32_t row;   /* of the weights */
    uint32_t grain; /* number of the grain, or of the body, owned or a copy; solid_of_wall of a wall */
    double arm[3];  /* from its centre, or the centre of its image, to the node */
    double share;   /* phi_i, then the grain's share of g */
};

/* The number that stands for a wall among those of grains, and back: -1 of a grain. */
static inline uint32_t solid_of_wall(int wall) {
    return UINT32_MAX - (uint32_t)wall;
}
static inline int solid_wall(uint32_t grain) {
    return grain > UINT32_MAX - WALLS_MAX ? (int)(UINT32_MAX - grain) : -1;
}

/* A pair that may be one until the next rebuild. */
struct solid_pair {
    uint32_t row, partner; /* partner: number and image code, as in a pair list */
};

/* All arrays are owned. All zero: empty. */
struct solid_field {
    size_t pairs, pair_room;
    struct solid_pair *pair; /* by row */
    size_t parts, part_room;
    struct solid_part *part; /* by row */
    size_t nodes;            /* rows that have parts */
    size_t *start;           /* [nodes + 1]: the parts of each of these rows */
};

/* phi at a distance over SOLID_EDGE spacings; g. Any thread. */
double solid_edge(double s);
double solid_gain(double phi, double kappa);

/* kappa of a step. */
double solid_kappa(double spacing, double viscosity, double dt);

/* The integrals of g and of g r^2 over space around a grain alone, the mean over all lattices: volume (length^dimension) and second
 * moment about an axis through the centre. */
void solid_mean(double radius, double spacing, double kappa, int dimension, double *volume, double *moment);

/* Takes the pairs of fluid particles [first, end) with grains from rows of pairs. */
void solid_pairs_take(struct solid_field *solid, const struct pair_rows *pairs, const uint8_t *kind,
                      size_t first, size_t end);

/* The places of nodes and grains. */
struct solid_places {
    const struct physics_context *bodies; /* of a scene that has bodies; NULL: there are none */
    const struct particle_state *state;   /* by particle number, owned and copies */
    const double (*shift)[4];             /* of image codes */
    size_t first;                         /* the particle of row 0 */
    const struct solid_part *at_wall;     /* by row: parts of walls, their share being phi */
    size_t at_walls;
    double spacing, kappa, hydraulic;
    int dimension;
};

/* Makes the parts at the present places, and shares out the gain; filled[row] = Phi of all `rows`. */
void solid_field_make(struct solid_field *solid, const struct solid_places *places, size_t rows,
                      double *filled);

void solid_field_free(struct solid_field *solid);

#endif
