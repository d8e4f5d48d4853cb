/* SPDX-License-Identifier: BSD-3-Clause */
/* Parts of a system of PETSc: its matrix, its solver, and what goes at the end of a program. */
#ifndef SCREE_PHYSICS_SOLVE_PETSC_PARTS_H
#define SCREE_PHYSICS_SOLVE_PETSC_PARTS_H

#include "physics/solve/petsc_system.h"

/* Systems without a matrix: the operator, before the solver is made; what the solver calls, after. */

bool petsc_free_make(struct petsc_system *system, struct error *error);
bool petsc_free_end(struct petsc_system *system, struct error *error);

/* Matrices of PETSc: backend.h says what each function does. */

bool petsc_matrix_make(struct petsc_system *system, const struct solve_rows *rows, struct error *error);
bool petsc_matrix_values(void *system, const double *value, struct error *error);
bool petsc_matrix_null_space(void *system, int regions, const int32_t *region, const double *sizes,
                             struct error *error);
bool petsc_matrix_multiply(void *system, const double *x, double *y, struct error *error);

/* Solvers of PETSc for a system whose matrix is made: backend.h says what each function does. */

bool petsc_solver_make(struct petsc_system *system, const struct solve_options *options, struct error *error);
bool petsc_solver_set_up(void *system, bool keep, struct error *error);
bool petsc_solver_solve(void *system, const double *b, double *x, bool guess, double tolerance,
                        struct solve_outcome *outcome, struct error *error);
bool petsc_solver_cycle(void *system, const double *r, double *z, struct error *error);

#endif
