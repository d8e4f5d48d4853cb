/* SPDX-License-Identifier: BSD-3-Clause */
/* What the files of the module of PETSc share: the library, a system, its matrix, its solver, and calls that name the function that
 * failed. */
#ifndef SCREE_PHYSICS_SOLVE_PETSC_PARTS_H
#define SCREE_PHYSICS_SOLVE_PETSC_PARTS_H

#include "physics/solve/backend.h"
#include <petscksp.h>

enum { PETSC_PRESETS_MAX = 64, PETSC_NAME_MAX = 96 };

/* PETSc as this run uses it. */
struct petsc_library {
    const struct comm *comm;
    bool ours;      /* started here, so ended here */
    char said[512]; /* the text of the first error since the last call of petsc_call */
    int presets;    /* options that stem from this module, not from the user */
    char preset[PETSC_PRESETS_MAX][PETSC_NAME_MAX];
};

struct petsc_system {
    struct petsc_library *library;
    struct solve_free work; /* of a system without a matrix, else empty */
    void *test;             /* of convergence, PETSc's */
    PetscInt asked;         /* the last iteration at which the caller was asked */
    PetscInt count;
    double pin;
    Mat matrix;
    KSP solver;
    Vec left, right; /* borrow arrays during a call */
};

/* Returns true if `code`, which the function named `call` returned, is no error; else fills `error` with the
 * call and PETSc's text. */
bool petsc_call(struct petsc_library *library, PetscErrorCode code, const char *call, struct error *error);

/* CALL(KSPSolve, solver, b, x): calls, and returns false from the caller where the call fails. */
#define CALL(function, ...)                                                                                  \
    do {                                                                                                     \
        if (!petsc_call(library, function(__VA_ARGS__), #function, error))                                   \
            return false;                                                                                    \
    } while (0)

/* Sets an option that the user has not set. */
bool petsc_preset(struct petsc_library *library, const char *prefix, const char *name, const char *value,
                  struct error *error);

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
