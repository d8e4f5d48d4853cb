/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains: the physics that every run has (engine/physics.h). It holds the contact law, the walls and the integrator; it
 * moves the grains by forces of contacts, unless the scene has another physics that moves them. What others ask of it
 * stands at the end. */
#ifndef SCREE_GRAINS_GRAINS_H
#define SCREE_GRAINS_GRAINS_H

#include "physics/grains/batch/force.h"
#include "engine/physics.h"
#include "physics/grains/motion/integrator.h"
#include "physics/grains/motion/timestep.h"
#include "physics/grains/walls/wall.h"

/* The overlaps that are expected, over the smaller radius (overlaps.h). */
struct overlaps {
    double met;      /* of the heaviest equal particles, or of one and a wall */
    double squeezed; /* of the softer contact of a grain between a particle and a support */
    double speed;    /* of that particle, length/time */
    double mass;     /* of that particle */
    double radius;   /* of that grain, length */
    double exponent; /* of the energy of the contact in its overlap */
    int material[2]; /* of the softer contact */
};

/* The stable step for future contacts, and the data from which it was found (stable.c). */
struct grains_stable {
    struct timestep_limits limits;
    double overlap_started; /* largest overlap at the start of a run, over the smaller radius */
    double speed_most;      /* the largest expected of an impact, however long the run; length/time */
    double speed_expected;  /* the largest of an impact until the end of the run; length/time */
    struct overlaps overlaps;
};

/* The own data of the physics. */
struct grains {
    struct law law;
    struct law_user *user; /* the law of a file; NULL: none */
    struct integrator_context motion;
    struct history *history; /* NULL: the law has none */
    struct walls *walls;     /* NULL: none */
    struct force_loop *loop; /* NULL: nothing touches, as the scene has no materials */
    struct force_context contact;
    struct force_exact *exact;        /* by thread: sums that no layout changes; NULL: not wanted */
    struct force_sums sums;           /* of the last evaluation, this rank's part */
    bool warned;                      /* of an overlap */
    double taken;                     /* sum of force_sums.taken since the start, this rank's part */
    struct wall_push push[WALLS_MAX]; /* of walls with servos */
    uint64_t pushed[WALLS_MAX]; /* the last step in which something pushed on a wall with a servo; 0: none */
    struct grains_stable stable;
    double wall_work;          /* of a checkpoint */
    char title[LAW_TITLE_MAX]; /* of the law, in a checkpoint */
};

struct extent; /* engine/notes.h */

/* Grains of a run; NULL if the run has none. */
struct grains *grains_of(const struct physics_set *set);

/* True if grains touch each other and walls: the scene has materials. */
bool grains_touch(const struct physics_context *context);

/* True if another physics finds the forces of contacts (force_context.solved), in PASS_CLOSE, and fills `sums`. */
bool grains_solved(const struct physics_context *context);

/* The walls; NULL: none. */
struct walls *grains_walls(const struct physics_context *context);

/* The contacts: a physics may ask for their work in its `create`. */
struct force_context *grains_contact(const struct physics_context *context);

/* The pair list of the contacts, that of a solver where one finds them; new after each rebuild. */
const struct pairlist *grains_list(const struct physics_context *context);

/* The motion of groups; a physics that carries grains sets `carried`. */
struct integrator_context *grains_motion(const struct physics_context *context);

/* The extent of a wall: of a mesh, at its place at the start; of a cylinder or a plane, as the scene gives
 * it. A plane that is not perpendicular to an axis has no bounds. */
struct extent grains_wall_extent(const struct grains *grains, const struct scene *scene, int wall);

/* True if what has this extent lies wholly outside of the box. */
bool grains_wall_apart(const struct scene *scene, const struct extent *extent);

#endif
