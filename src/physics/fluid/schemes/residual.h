/* SPDX-License-Identifier: BSD-3-Clause */
/* Is the solution of a linear system good enough to go on with? The true residual decides, since a singular
 * matrix can make a solver report convergence without it. */
#ifndef SCREE_SCHEMES_RESIDUAL_H
#define SCREE_SCHEMES_RESIDUAL_H

#include "physics/solve/solve.h"

/* The largest |b - A x| / |b| of a solve with which a run goes on. */
#define RESIDUAL_MOST 0.1

/* True if the last solve is good enough: it converged, or ended within SOLVE_DOUBT tolerances all the same, and its
 * residual is at most RESIDUAL_MOST. Else `error`, of kind ERROR_PHYSICS, names the system, the residual,
 * the solver's reason and what may help. Alike on all ranks. */
bool residual_check(const struct solve_report *report, const char *system, struct error *error);

#endif
