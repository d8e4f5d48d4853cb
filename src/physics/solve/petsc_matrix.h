/* SPDX-License-Identifier: BSD-3-Clause */
/* Matrices of PETSc: backend.h says what each function does. */
#ifndef SCREE_SOLVE_PETSC_MATRIX_H
#define SCREE_SOLVE_PETSC_MATRIX_H

#include "physics/solve/petsc_system.h"

bool petsc_matrix_make(struct petsc_system *system, const struct solve_rows *rows, struct error *error);
bool petsc_matrix_values(void *system, const double *value, struct error *error);
bool petsc_matrix_null_space(void *system, int regions, const int32_t *region, const double *sizes,
                             struct error *error);
bool petsc_matrix_multiply(void *system, const double *x, double *y, struct error *error);

#endif
