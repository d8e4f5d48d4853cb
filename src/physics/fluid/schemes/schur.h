/* SPDX-License-Identifier: BSD-3-Clause */
/* The Schur complement of steady Stokes flow between open sides of given pressure, approximately inverted.
 *
 * With M = - div grad of a velocity, G = grad and D = - div it is S = - D M^-1 G. In a space without walls S = -1. Between
 * walls that are much nearer to one another than the open sides are, M^-1 is about a diagonal matrix k, and S = div k grad: the
 * flow is Darcy's, and a pressure that changes along the whole way answers by (pore / way)^2 only, some 10^-5 in a packing. Hence
 *
 *   S^-1 = - (1 + (- div k grad)^-1),   M k = 1
 *
 * which is right for both (of a wave w among walls with M = w^2 + 1 / k it is exact), as the preconditioners of Cahouet and Chabard, Int. J. Numer.
 * Methods Fluids 8 (1988) 869, are for flows in time. k, the sums of the rows of M^-1, is the velocity under a force of one without a pressure: of
 * each place its own, so that open space and dense packings may stand beside each other. */
#ifndef SCREE_SCHEMES_SCHUR_H
#define SCREE_SCHEMES_SCHUR_H

#include "physics/fluid/operators/assembly.h"

struct schur {
    struct solve_system *system; /* of - div k grad */
    double *value;               /* [rows] scratch */
};

/* Makes the matrix and its multigrid from that of a velocity, M in units of 1 / `scale` (scale M u = scale gives k): one
 * rough solve. The assembly's values are overwritten. False with an error of an option. Collective, as all here. */
bool schur_make(struct schur *schur, struct solve *solve, struct assembly *assembly, const struct flow *flow,
                struct solve_system *velocity, double scale, const char *preconditioner, struct error *error);
void schur_free(struct schur *schur);

/* z = an approximate S^-1 r; both [rows]. */
void schur_apply(struct schur *schur, const struct flow *flow, const double *r, double *z);

#endif
