/* SPDX-License-Identifier: BSD-3-Clause */
/* Systems without a matrix: the operator, before the solver is made; what the solver calls, after. */
#ifndef SCREE_SOLVE_PETSC_FREE_H
#define SCREE_SOLVE_PETSC_FREE_H

#include "physics/solve/petsc_system.h"

bool petsc_free_make(struct petsc_system *system, struct error *error);
bool petsc_free_end(struct petsc_system *system, struct error *error);

#endif
