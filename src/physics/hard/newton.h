/* SPDX-License-Identifier: BSD-3-Clause */
/* Newton's method for the contact problem of a step, with a Krylov method for its linear systems.
 *
 * The unknowns are y, six a body: V = V* + S y, V* the velocities without contacts, S the roots of 1/mass and inverse
 * inertia (newton_body.h). The solution is y = St Jt p with impulses p that are on the functions of their rows (newton_row.h). A step takes each function by its
 * derivative at the point where a visit of the row by Gauss and Seidel would leave it: p = p0 - G (J V - u0), whence
 *
 *   (1 + St Jt G J S) dy = St Jt (p0 - G (u - u0)) - y.
 *
 * As that point tells which contacts push and slip, the method is one of active sets (of the kind of Alart and Curnier 1991):
 * derivatives at the present velocities, in which an error of a stiff row is large, need ten times as many steps. The matrix is not
 * symmetric where contacts slip. The method begins with the impulses of the rows, which sweeps have found, and takes one step at least,
 * as the residual does not tell an error that all rows share.
 *
 * Where a step leaves more than half of the miss, some sweeps of Gauss and Seidel follow: impacts want these. But sweeps may take the miss
 * away, keep the error that rows share, and hide which contacts would slip by it, so that the next step is the same again. Behind
 * a few such steps some go without sweeps; if they come no nearer the method goes back to where it was nearest. The
 * miss is absolute: impulses that grow without bound miss little of themselves.
 *
 * Products are sums over rows, and over ranks by the copies of bodies: no matrix is made but that of the
 * preconditioner (newton_blocks.h). */
#ifndef SCREE_HARD_NEWTON_H
#define SCREE_HARD_NEWTON_H

#include "physics/hard/clumps.h"
#include "physics/hard/newton_blocks.h"
#include "physics/solve/solve.h"

struct hard_newton {
    const struct comm *comm; /* borrowed, as the next four */
    struct hard_problem *problem;
    struct hard_border *border;
    const struct hard_clumps *clumps;
    struct solve *solve;         /* NULL: nothing solved yet */
    struct solve_system *system; /* of `bodies` bodies; NULL: none yet */
    size_t bodies;               /* owned */
    struct hard_blocks blocks;
    struct hard_newton_row *row;
    struct hard_body *free; /* of owned bodies: V* */
    double (*y)[6];         /* of owned bodies: the unknowns */
    double (*right)[6], (*step)[6];
    double (*way)[6], (*sum)[6]; /* of all bodies: velocities, and sums of impulses */
    double (*root)[HARD_ROOT];   /* of all bodies (newton_body.h); NULL: all are spheres */
    size_t row_room, free_room, own_room[3], all_room[3];
    double miss; /* the 2-norm of what one more visit of each row would change of its impulses */
};

struct hard_newton_limits {
    int steps;        /* at most */
    double tolerance; /* of the residual of Alart and Curnier */
    double begin;     /* the residual of the impulses that the rows begin with */
};

struct hard_newton_result {
    int steps, iterations; /* of Newton's method, of its linear solver */
    double residual; /* where it is above the tolerance: the least of all, and the impulses are its own */
};

void hard_newton_free(struct hard_newton *newton);

/* A new pair list: the numbers of bodies may be others. */
void hard_newton_renew(struct hard_newton *newton);

/* Keeps the velocities without contacts of `bodies` owned bodies. */
void hard_newton_begin(struct hard_newton *newton, struct hard_problem *problem, struct hard_border *border,
                       size_t bodies);

/* Solves the problem from the impulses that the rows have: these and all velocities become the solution's. Masses are
 * whole. Collective. */
struct hard_newton_result hard_newton_solve(struct hard_newton *newton,
                                            const struct hard_newton_limits *limits);

#endif
