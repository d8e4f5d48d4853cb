/* SPDX-License-Identifier: BSD-3-Clause */
/* Stability of the present contacts: is a time step stable for the springs and dampers between the
 * particles as they now touch, whatever their number, directions and overlaps?
 *
 *   With h the step, spring k and damper c of a contact act like one of stiffness a = h^2 k + 2 h c, and the
 * scheme is stable iff no eigenvalue of the assembly of all a, over masses and inertias, exceeds 4. Each
 * particle has a local eigenvalue L, that of its own contacts with its partners held fixed; the largest of
 * the assembly is at most the largest L_i + L_j of two that touch (docs/physics.md). So two passes over the
 * pairs find a bound, and both run in parallel:
 *
 *     stability_pairs, stability_walls    sums over the contacts of each particle: STABILITY_SUMS numbers
 *     (ranks: sums of copies are added to their originals)
 *     stability_solve                     L of the owned particles
 *     (ranks: copies get the L of their originals)
 *     stability_worst                     the largest L_i + L_j
 *
 * Contributions are rounded to multiples of 2^-30 (of the bound, 4), so sums do not depend on their order.
 */
#ifndef SCREE_MOTION_STABILITY_H
#define SCREE_MOTION_STABILITY_H

#include "physics/grains/batch/force.h"
#include "physics/grains/walls/wall.h"

/* Over mass and inertia: the tensor of displacements xx yy zz xy xz yz; with spin that of rotations, and the
 * vector that couples both. */
enum { STABILITY_PUSH = 6, STABILITY_SUMS = 15 };

struct stability {
    double step;   /* h, time */
    size_t count;  /* particles, copies included */
    int sums;      /* numbers a particle: STABILITY_SUMS, or STABILITY_PUSH without spin */
    double *sum;   /* the sums, without unit */
    double *local; /* L of each particle, without unit */
    int walls;
    double *wall; /* L of each free wall, without unit; 0 of other walls */
};

/* One spring between two particles as both see it. */
struct stability_contact {
    size_t i, j;
    double normal[3];        /* from i to j */
    double radius;           /* R* */
    double lever;            /* of the turning spring, over the radius of the particle */
    double push, turn, roll; /* a = h^2 k + 2 h c of the three springs */
    double twist;            /* the same of the twisting spring, times length^2 */
};

/* Adds a spring at the owned particle i, with its normal away from i. One thread. */
void stability_add(struct stability *stability, const struct particles *particles, size_t i,
                   const struct stability_contact *contact);

/* Raises L of particle i, owned or a copy, by a bound, whatever the direction. Any thread. */
void stability_bound(struct stability *stability, size_t i, double bound);

/* Makes room for the particles of the context, all sums 0; free releases. One thread. */
void stability_create(struct stability *stability, const struct force_context *context, double step);
void stability_free(struct stability *stability);

/* Adds the contacts of all pairs of the list. With newton on, the sums of copies are then the parts that
 * their originals lack. Opens its own team. */
void stability_pairs(struct stability *stability, const struct force_context *context);

/* Adds the contacts of particles with walls: `count` rows of walls_contacts; `material` is that of each wall.
 * One thread. */
void stability_walls(struct stability *stability, const struct force_context *context,
                     const struct force_contact *contacts, size_t count, const int *material);

/* Adds to L of free walls the contacts of thread `thread`'s share of the particles near walls, this rank's part. The sum over
 * the contacts, each with its stiffest spring and the largest inverse mass of the wall at its place, is no less than the
 * largest eigenvalue of all springs on the wall. One thread, thread after thread. */
void stability_free_walls(struct stability *stability, const struct force_context *context,
                          const struct walls *walls, int thread);

/* Fills `local` of the owned particles from their sums. Opens its own team. */
void stability_solve(struct stability *stability, const struct particles *particles);

/* The largest L_i + L_j of two of this rank's particles that touch, and L of one that touches a wall plus that of any free
 * wall; 0 without contacts. The step is stable if no rank's is above 4. Opens its own team. */
double stability_worst(const struct stability *stability, const struct force_context *context);

/* Bounds the largest eigenvalue of [[T, X], [X^T, R]], T and R symmetric (xx yy zz xy xz yz), X the cross
 * product with a vector: exact where that is 0. `sums` is 6 (T alone) or 15. For tests, too. */
double stability_eigenvalue(const double *sum, int sums);

#endif
