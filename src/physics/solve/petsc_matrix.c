/* SPDX-License-Identifier: BSD-3-Clause */
/* Matrices of PETSc from rows: values, the pinned diagonal, null spaces, products. */
#include "physics/solve/petsc_parts.h"

#include <math.h>

/* Multiplies the diagonal by 1 + pin. A direct solve on the coarsest level of a multigrid method then divides by
 * a number that is small but no rounding error; the smoothest mode changes by pin (L / dx)^2. */
static bool pin_diagonal(struct petsc_system *system, struct error *error) {
    struct petsc_library *library = system->library;
    Vec diagonal;
    if (system->pin == 0)
        return true;
    CALL(MatCreateVecs, system->matrix, NULL, &diagonal);
    CALL(MatGetDiagonal, system->matrix, diagonal);
    CALL(VecScale, diagonal, 1 + system->pin);
    CALL(MatDiagonalSet, system->matrix, diagonal, INSERT_VALUES);
    CALL(VecDestroy, &diagonal);
    return true;
}

bool petsc_matrix_make(struct petsc_system *system, const struct solve_rows *rows, struct error *error) {
    struct petsc_library *library = system->library;
    _Static_assert(sizeof(PetscInt) == sizeof(int32_t), "a PETSc with 32-bit integers");
    CALL(MatCreateMPIAIJWithArrays, library->comm->handle, rows->count, rows->count, PETSC_DETERMINE,
         PETSC_DETERMINE, rows->start, rows->column, rows->value, &system->matrix);
    return pin_diagonal(system, error);
}

bool petsc_matrix_values(void *self, const double *value, struct error *error) {
    struct petsc_system *system = self;
    struct petsc_library *library = system->library;
    CALL(MatUpdateMPIAIJWithArray, system->matrix, value);
    return pin_diagonal(system, error);
}

/* The vectors that are 1 / sqrt(rows of the region) in one region, and 0 elsewhere. */
static bool region_vectors(struct petsc_system *system, int regions, const int32_t *region,
                           const double *sizes, Vec *vector, struct error *error) {
    struct petsc_library *library = system->library;
    for (int r = 0; r < regions; r++) {
        PetscScalar *value;
        CALL(MatCreateVecs, system->matrix, &vector[r], NULL);
        CALL(VecGetArray, vector[r], &value);
        for (PetscInt i = 0; i < system->count; i++)
            value[i] = region[i] == r ? 1 / sqrt(sizes[r]) : 0;
        CALL(VecRestoreArray, vector[r], &value);
    }
    return true;
}

bool petsc_matrix_null_space(void *self, int regions, const int32_t *region, const double *sizes,
                             struct error *error) {
    struct petsc_system *system = self;
    struct petsc_library *library = system->library;
    MatNullSpace space;
    Vec vector[SOLVE_REGIONS_MAX];
    bool one = regions == 1;
    if (!one && !region_vectors(system, regions, region, sizes, vector, error))
        return false;
    CALL(MatNullSpaceCreate, library->comm->handle, one ? PETSC_TRUE : PETSC_FALSE, one ? 0 : regions,
         one ? NULL : vector, &space);
    CALL(MatSetNullSpace, system->matrix, space);
    CALL(MatNullSpaceDestroy, &space);
    for (int r = 0; !one && r < regions; r++)
        CALL(VecDestroy, &vector[r]);
    return true;
}

bool petsc_matrix_multiply(void *self, const double *x, double *y, struct error *error) {
    struct petsc_system *system = self;
    struct petsc_library *library = system->library;
    CALL(VecPlaceArray, system->right, x);
    CALL(VecPlaceArray, system->left, y);
    CALL(MatMult, system->matrix, system->right, system->left);
    CALL(VecResetArray, system->right);
    CALL(VecResetArray, system->left);
    return true;
}
