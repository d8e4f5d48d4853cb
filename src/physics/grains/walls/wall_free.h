/* SPDX-License-Identifier: BSD-3-Clause */
/* A free wall: a body whose shape is a wall. Grains push, turn and carry it; so do gravity and, where it has one freedom
 * alone, a load, a spring and a damper. Other walls do where a scene names them (physics/blocks).
 *
 * Mass and inertia are given, or follow from the shape at rest: of a closed mesh, a box, or a cylinder that is felt from
 * outside those of the solid; of other shapes those of a thin sheet of uniform mass (of a tube, without ends). A plane
 * and an endless cylinder have a mass alone.
 *
 *   ALL, SHIFT     the centre of mass moves by the leapfrog scheme of the grains, as bodies do; ALL turns by
 *                  rotor_advance under its angular momentum in space
 *   ALONG, ABOUT   a way q (length or angle) with M q'' = Q - c q', the damper at the mean of the speeds before and
 *                  after the step, which is stable for any c. The pose follows from q in closed form, so that no error
 *                  adds up across the freedom
 *
 * In two dimensions the wall stays in the plane: ALL turns about z.
 *
 * The motion maps space to space and acts on the pose in which the wall became free: at the start, or where a stage frees
 * it. Coordinates are box-relative. Any thread may read; one writes.
 *
 * Velocities that are given act where the wall becomes free, and at a resume where another one is given than before: by a stage,
 * or by the user. They are those of the full step, which wall_free_stagger moves back. */
#ifndef SCREE_WALLS_WALL_FREE_H
#define SCREE_WALLS_WALL_FREE_H

#include "physics/grains/walls/wall_mesh.h"
#include "physics/grains/walls/wall_motion.h"

/* The velocities that a user may give: velocity, angular velocity, speed. */
enum { WALL_FREE_VELOCITY, WALL_FREE_OMEGA = 3, WALL_FREE_SPEED = 6, WALL_FREE_GIVEN };

/* The state: numbers of a restart, doubles alone. */
struct wall_free_state {
    double known;       /* 1 from the first step on; 0: the wall has just become free */
    double place[3];    /* ALL, SHIFT: displacement of the centre of mass */
    double velocity[3]; /* of it, in the last half step */
    double turn[4];     /* ALL: quaternion from the principal axes to space */
    double spin[3];     /* ALL: angular momentum about the centre of mass, in the last half step */
    double way, rate;   /* ALONG, ABOUT: displacement or angle, and its rate in the last half step */
    double taken;       /* work of the damper; energy */
    double omega
        [3]; /* ALL: angular velocity of the last half step, the mean of those before and after the turn */
    double given[WALL_FREE_GIVEN]; /* the velocities that were given last; NAN: none */
};

/* What is shown: at the full step. */
struct wall_free_full {
    double velocity[3]; /* of the centre (struct wall_pose) */
    double omega[3];
    double
        energy; /* of motion, of the spring, and of gravity and load, these from the place where it became free */
    double motion; /* of the energy that of motion and of the spring */
    double taken;
};

struct wall_free {
    struct wall_free_options options; /* as given; direction of length 1, points box-relative */
    bool flat;                        /* in two dimensions */
    double mass;
    struct law_vector rest; /* centre of mass of the wall at rest */
    double extent; /* distance of the surface from there, at most; of an endless cylinder across its axis */
    double inertia[3];        /* ALL: principal moments, from small to large; ABOUT: about the axis, thrice */
    double axes_rest[4];      /* ALL: quaternion of the principal axes at rest */
    struct law_vector centre; /* of mass, where the wall became free */
    double axes[4];           /* and the axes there */
    struct wall_free_state state;
    bool new_velocity,
        new_omega; /* given since the last step: of the full step. Of one freedom the first is the rate */
    struct wall_free_full full;
};

/* Finds mass and inertia; `mesh` is NULL for planes and cylinders. Fails (user) if the shape has no volume for a density,
 * or no body has such moments of inertia. One thread. Destroy frees and nulls. */
bool wall_free_create(struct wall_free **free, const struct wall_options *options,
                      const struct wall_mesh *mesh, const struct box *box, struct error *error);
void wall_free_destroy(struct wall_free **free);

/* The wall is free from the pose `base` on: where its state is not known, with the velocities of the options; else it goes
 * on, but for velocities that are given anew. */
void wall_free_begin(struct wall_free *free, const struct wall_transform *base);

/* The centre of the wall at rest (struct wall_pose), for the pose in which it became free. */
struct law_vector wall_free_centre(const struct wall_free *free, const struct wall_transform *base);

/* The motion since the wall became free, and the velocities of the last half step. */
struct wall_transform wall_free_place(const struct wall_free *free);
struct wall_twist wall_free_twist(const struct wall_free *free);

/* Kick and drift of one step; `push` as it was found for the present pose. */
void wall_free_advance(struct wall_free *free, const struct wall_push *push, const double gravity[3],
                       double dt);

/* Moves the velocities back by half of dt, as integrator_stagger does for grains; those that are given since the last step by
 * half of `step`, its length. */
void wall_free_stagger(struct wall_free *free, const struct wall_push *push, const double gravity[3],
                       double dt, double step);

/* Fills `full`; dt: the length of the steps by half of which velocities lie behind. */
void wall_free_find_full(struct wall_free *free, const struct wall_push *push, const double gravity[3],
                         double dt);

/* The inverse of the mass that the wall has against a push along a unit vector at a place of it. */
double wall_free_yield(const struct wall_free *free, struct law_vector at, struct law_vector along);

/* A bound on that of all directions at a place; of all places and directions; against pushes that are spread over the wall, over
 * their number: of a wall that turns about an axis as if it were a blade from the axis to the far end; and on the inverse of the inertia against turning, 0 of walls that do not
 * turn. */
double wall_free_yield_worst(const struct wall_free *free, struct law_vector at);
double wall_free_yield_most(const struct wall_free *free);
double wall_free_yield_spread(const struct wall_free *free);
double wall_free_turn_yield(const struct wall_free *free);

/* Writes mass and freedom as a text. */
void wall_free_describe(const struct wall_free *free, char *text, size_t room);

#endif
