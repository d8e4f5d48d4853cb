/* SPDX-License-Identifier: BSD-3-Clause */
/* The problem that the last step has solved, in local form: velocities of contacts against impulses (data/formats/contact_problem.h),
 * for other solvers.
 *
 * A row with springs is a rigid one with a softer W: u_n + bias + soft_n p >= 0 beside p >= 0 is its normal row, and
 * u_t + soft_t (q - hold) slides against q. What a row of row.h has beyond that is given as it is at the solution: Hertz's spring
 * by its tangent, and a row that is released at its largest speed by the spring that it then has. The pass of restitution
 * is no part of the problem. */
#ifndef SCREE_HARD_LOCAL_FORM_H
#define SCREE_HARD_LOCAL_FORM_H

#include "data/formats/contact_problem.h"
#include "physics/hard/hard_solve.h"

/* Owns its arrays; hard_form_free releases. */
struct hard_form {
    size_t contacts;
    int32_t *start, *row;
    double *value, *q, *mu, *r, *u, *soft, *shift;
    int64_t *id;
};

/* Makes the problem on rank 0, contacts in the order of their ids; other ranks get none. False if W has more than 2^31 - 1 numbers.
 * Collective, one thread a rank. */
bool hard_form_make(struct hard_form *local, const struct hard_solver *solver,
                    const struct particles *particles);
void hard_form_free(struct hard_form *local);

#endif
