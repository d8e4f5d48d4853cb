/* SPDX-License-Identifier: BSD-3-Clause */
/* Solvers of PETSc for a system whose matrix is made: backend.h says what each function does. */
#ifndef SCREE_SOLVE_PETSC_SOLVER_H
#define SCREE_SOLVE_PETSC_SOLVER_H

#include "physics/solve/petsc_system.h"

bool petsc_solver_make(struct petsc_system *system, const struct solve_options *options, struct error *error);
bool petsc_solver_set_up(void *system, bool keep, struct error *error);
bool petsc_solver_solve(void *system, const double *b, double *x, bool guess, double tolerance,
                        struct solve_outcome *outcome, struct error *error);
bool petsc_solver_cycle(void *system, const double *r, double *z, struct error *error);

#endif
