/* SPDX-License-Identifier: BSD-3-Clause */
/* The implicit part of the momentum equation, (1 - a div grad) u* = b with a = theta dt viscosity / density, one
 * component after another. Without a slip length all components have one matrix; with one, each has its own,
 * and what couples them at oblique walls is taken from the velocity of the sweep before. */
#ifndef SCREE_SCHEMES_MOMENTUM_H
#define SCREE_SCHEMES_MOMENTUM_H

#include "physics/fluid/operators/assembly.h"

struct momentum {
    int systems; /* 1, or one a component */
    struct solve_system *system[3];
    double implicit;      /* a of the present values */
    double residual;      /* the largest true one of the last step's solves */
    double *side, *guess; /* [rows]: scratch */
};

/* Makes the systems for a factor `implicit`, a (length^2). The assembly's values are overwritten. False with
 * an error of an option. Collective. */
bool momentum_make(struct momentum *momentum, struct solve *solve, struct assembly *assembly,
                   const struct flow *flow, double implicit, const struct solve_options *options,
                   struct error *error);
void momentum_free(struct momentum *momentum);

/* The weights have new values: the next solve fills the matrices again. */
void momentum_refill(struct momentum *momentum);

/* Solves for u*, which goes to flow->predicted of the owned particles; `side`, by row, is b without the walls'
 * share. The velocity of the flow is the first guess. False if a solver did not converge, or the true residual
 * is above `worst`: `error` says so. Collective. */
bool momentum_solve(struct momentum *momentum, struct assembly *assembly, const struct flow *flow,
                    double implicit, const double (*side)[3], struct error *error);

#endif
