/* SPDX-License-Identifier: BSD-3-Clause */
/* What others ask of walls that are free (wall_free.h). Where a wall is not free, the functions do nothing and give 0. */
#ifndef SCREE_WALLS_WALLS_FREE_H
#define SCREE_WALLS_WALLS_FREE_H

#include "physics/grains/walls/wall.h"

/* True if this wall is free. */
bool walls_is_free(const struct walls *walls, int wall);

/* The acceleration of free walls; 0 before. One thread. */
void walls_set_gravity(struct walls *walls, const double gravity[3]);

/* Moves the velocities of free walls back by half of dt, as integrator_stagger does for grains; those that are given since
 * the last step, as of a wall that has just become free, by half of `step`, its length. `push` as of walls_advance. One thread. */
void walls_stagger(struct walls *walls, const struct wall_push *push, double dt, double step);

/* Finds velocities and energies of free walls at the full step, for walls_velocity, walls_energy and walls_taken. dt: the length of the steps by half
 * of which velocities lie behind. One thread. */
void walls_full_step(struct walls *walls, const struct wall_push *push, double dt);

/* The energy of motion and of springs of free walls, as walls_full_step found it. */
double walls_motion(const struct walls *walls);

/* The work that the dampers of free walls took, as walls_full_step found it. */
double walls_taken(const struct walls *walls);

/* The numbers of a free wall that a resume needs, the same on every rank: their count, and the first one; 0: none. They are
 * read before walls_set_pose. */
int walls_free_numbers(struct walls *walls, int wall, double **number);

/* The inverse of the mass that a wall has against a push along a unit vector at a place of it, in the wall's own image; the
 * most in any direction there; the most at any place and in any direction; that against pushes spread over the wall, over their
 * number; and the most of the inverse of its inertia. Any thread. */
double walls_yield(const struct walls *walls, int wall, const double at[3], const double along[3]);
double walls_yield_worst(const struct walls *walls, int wall, const double at[3]);
double walls_yield_most(const struct walls *walls, int wall);
double walls_yield_spread(const struct walls *walls, int wall);
double walls_turn_yield(const struct walls *walls, int wall);

/* The area of a wall on which particles may lie: of both sides of an open mesh, of a plane its section of the box (in two
 * dimensions a length), of an endless cylinder that of a length of the longest edge of the box. 0: unknown. */
double walls_whole_area(const struct walls *walls, int wall);

/* Writes what `scree check` says of a wall: mass and freedom of a free one; spacing, memory and error of a field. */
void walls_describe(const struct walls *walls, int wall, char *text, size_t room);

#endif
