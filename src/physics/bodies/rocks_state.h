/* SPDX-License-Identifier: BSD-3-Clause */
/* The contacts of rocks on this rank, for rocks_pairs.c and rocks_force.c. */
#ifndef SCREE_BODIES_ROCKS_STATE_H
#define SCREE_BODIES_ROCKS_STATE_H

#include "physics/bodies/rocks.h"
#include "physics/bodies/shapes/recall.h"
#include "physics/bodies/shapes/touch.h"
#include "physics/grains/walls/wall_solid.h"

/* Sums over the points of a contact in the last evaluation. */
struct rocks_sums {
    double normal, tangential, taken; /* energies */
    double virial[6];
    double overlap;   /* over the smaller radius of both balls */
    double impedance; /* of a wall (struct wall_push) */
};

/* A pair of balls of which one at least has a rock, or one and a wall. */
struct rocks_pair {
    uint32_t end[2]; /* numbers of the particles, the lower id first; of a wall: ROCKS_WALL and its number */
    int wall;        /* -1: a pair */
    struct wall_group group; /* of a wall: its pieces nearby ... */
    double normal[3];        /* ... and the normal of the deepest contact with it, towards it */
    uint32_t number;         /* of the pair in the list */
    uint8_t image;           /* image code of the pair's second particle in the list ... */
    bool turned;             /* ... which is the first end */
    bool gives[2];           /* which ends get the force here */
    int points;
    struct touch_memory point[TOUCH_POINTS_MAX];
    struct gjk_simplex simplex;
    double force[3], torque[2][3]; /* on the second end, about the centres of both */
    struct rocks_sums sums;
};
#define ROCKS_WALL UINT32_MAX

/* One end of a pair, at the particle that it is. */
struct rocks_end {
    uint32_t pair;
    uint8_t side;
    int64_t partner; /* id, or below 0: a wall */
};

/* A rock as it stands. */
struct rocks_stand {
    uint32_t particle;
    double turn[9];
    double (*corner)[3];
    struct posed posed;
    double inner; /* radius of the sphere about the centre that lies inside */
};

struct rocks {
    size_t pairs, room;
    struct rocks_pair *pair;
    size_t particles; /* owned and copies */
    size_t *first;    /* ends of particle k: end[first[k]] ... [first[k + 1]) */
    struct rocks_end *end;
    int32_t *stand_of; /* of each particle: its number in `stand`; -1: no rock */
    size_t stands;
    struct rocks_stand *stand;
    double (*corner)[3];      /* of all rocks */
    struct solid dot;         /* the core of grains that are no rocks */
    struct history_rows rows; /* by owned particle, as long as `carried`; */
    bool carried;             /* the rows are those of the present, or of a checkpoint */
};

/* The number of the shape of each particle, -1: it is no rock; its orientation. */
int32_t *rocks_shapes(const struct particles *particles);
double (*rocks_orientations(const struct particles *particles))[4];

/* The vector from the first end of a pair to the second one. */
void rocks_apart(const struct rocks_pair *pair, const struct particles *particles,
                 const struct pairlist *list, double apart[3]);

#endif
