/* SPDX-License-Identifier: BSD-3-Clause */
/* Krylov methods and preconditioners of PETSc, with the settings that were measured to serve scree's matrices. */
#include "physics/solve/petsc_parts.h"

#include <stdio.h>
#include <string.h>

enum { EXTRAS_MAX = 6 };

/* A preconditioner: PETSc's type and what else is set, unless the user sets it. Aggressive coarsening on the
 * finest level costs BoomerAMG two or three iterations more, and halves its set-up and its memory. */
static const struct preconditioner {
    const char *name, *type;
    const char *extra[EXTRAS_MAX][2];
} preconditioners[] = {
    {"boomeramg",
     PCHYPRE,
     {{"pc_hypre_type", "boomeramg"},
      {"pc_hypre_boomeramg_strong_threshold", "0.5"},
      {"pc_hypre_boomeramg_coarsen_type", "HMIS"},
      {"pc_hypre_boomeramg_interp_type", "ext+i"},
      {"pc_hypre_boomeramg_P_max", "4"},
      {"pc_hypre_boomeramg_agg_nl", "1"}}},
    {"gamg",
     PCGAMG,
     {{"pc_gamg_threshold", "0.02"}, {"mg_levels_ksp_type", "richardson"}, {"mg_levels_pc_type", "sor"}}},
    {"ml", PCML, {{NULL, NULL}}},
    {"ilu", PCBJACOBI, {{"sub_pc_type", "ilu"}}},
    {"sor", PCSOR, {{NULL, NULL}}},
    {"jacobi", PCJACOBI, {{NULL, NULL}}},
    {"none", PCNONE, {{NULL, NULL}}}};

static const struct method {
    const char *name, *type;
    PCSide side;
} methods[] = {{"fgmres", KSPFGMRES, PC_RIGHT},
               {"gmres", KSPGMRES, PC_RIGHT},
               {"lgmres", KSPLGMRES, PC_RIGHT},
               {"bicgstab", KSPBCGS, PC_RIGHT},
               {"cg", KSPCG, PC_LEFT}};

static const struct preconditioner *find_preconditioner(const char *name) {
    for (size_t k = 0; k < sizeof preconditioners / sizeof *preconditioners; k++)
        if (strcmp(preconditioners[k].name, name) == 0)
            return &preconditioners[k];
    return NULL;
}

static const struct method *find_method(const char *name) {
    for (size_t k = 0; k < sizeof methods / sizeof *methods; k++)
        if (strcmp(methods[k].name, name) == 0)
            return &methods[k];
    return NULL;
}

static bool choose_preconditioner(struct petsc_system *system, const struct solve_options *options,
                                  struct error *error) {
    struct petsc_library *library = system->library;
    const struct preconditioner *row = find_preconditioner(options->preconditioner);
    PC pc;
    if (row == NULL)
        return error_set(error, ERROR_USER, "no preconditioner '%s'; there are: %s", options->preconditioner,
                         "boomeramg, gamg, ml, ilu, sor, jacobi, none");
    CALL(KSPGetPC, system->solver, &pc);
    if (system->work.precondition != NULL)
        return true;
    if (!petsc_call(library, PCSetType(pc, row->type), "PCSetType", error)) {
        struct error why = *error;
        *error = (struct error){0};
        return error_set(error, ERROR_USER, "this PETSc has no preconditioner '%s': %s", row->name, why.text);
    }
    for (int k = 0; k < EXTRAS_MAX && row->extra[k][0] != NULL; k++)
        if (!petsc_preset(library, options->prefix, row->extra[k][0], row->extra[k][1], error))
            return false;
    return true;
}

static bool choose_method(struct petsc_system *system, const struct solve_options *options,
                          struct error *error) {
    struct petsc_library *library = system->library;
    const struct method *row = find_method(options->method);
    if (row == NULL)
        return error_set(error, ERROR_USER, "no Krylov method '%s'; there are: %s", options->method,
                         "fgmres, gmres, lgmres, bicgstab, cg");
    PetscBool other = PETSC_FALSE; /* the user's method may know neither this side nor this norm */
    CALL(PetscOptionsHasName, NULL, options->prefix, "-ksp_type", &other);
    CALL(KSPSetType, system->solver, row->type);
    if (system->work.precondition == NULL && !other) {
        CALL(KSPSetPCSide, system->solver, row->side);
        CALL(KSPSetNormType, system->solver, KSP_NORM_UNPRECONDITIONED);
    }
    CALL(KSPGMRESSetRestart, system->solver, options->restart);
    if (options->augment > 0 && options->augment < options->restart) {
        CALL(KSPLGMRESSetAugDim, system->solver, options->augment);
        CALL(KSPLGMRESSetConstant, system->solver);
    }
    CALL(KSPSetTolerances, system->solver, options->tolerance, PETSC_DEFAULT, PETSC_DEFAULT,
         options->iterations);
    return true;
}

/* hypre keeps a copy of a matrix of PETSc's form: the matrix becomes one of hypre's own. */
static bool give_up(struct petsc_system *system, struct error *error) {
    struct petsc_library *library = system->library;
    PetscBool hypre = PETSC_FALSE;
    PC pc;
    CALL(KSPGetPC, system->solver, &pc);
    CALL(PetscObjectTypeCompare, (PetscObject)pc, PCHYPRE, &hypre);
    if (!hypre)
        return true;
    CALL(MatConvert, system->matrix, MATHYPRE, MAT_INPLACE_MATRIX, &system->matrix);
    CALL(KSPSetOperators, system->solver, system->matrix, system->matrix);
    return true;
}

bool petsc_solver_make(struct petsc_system *system, const struct solve_options *options,
                       struct error *error) {
    struct petsc_library *library = system->library;
    CALL(KSPCreate, library->comm->handle, &system->solver);
    CALL(KSPSetOptionsPrefix, system->solver, options->prefix);
    CALL(KSPSetOperators, system->solver, system->matrix, system->matrix);
    if (!choose_method(system, options, error) || !choose_preconditioner(system, options, error))
        return false;
    if (!petsc_call(library, KSPSetFromOptions(system->solver), "KSPSetFromOptions", error))
        error->kind = ERROR_USER; /* a type or value that PETSc does not know */
    return error->kind == ERROR_NONE && (!options->given_up || give_up(system, error));
}

bool petsc_solver_set_up(void *self, bool keep, struct error *error) {
    struct petsc_system *system = self;
    struct petsc_library *library = system->library;
    CALL(KSPSetReusePreconditioner, system->solver, keep ? PETSC_TRUE : PETSC_FALSE);
    CALL(KSPSetOperators, system->solver, system->matrix, system->matrix);
    CALL(KSPSetUp, system->solver);
    return true;
}

bool petsc_solver_solve(void *self, const double *b, double *x, bool guess, double tolerance,
                        struct solve_outcome *outcome, struct error *error) {
    struct petsc_system *system = self;
    struct petsc_library *library = system->library;
    PetscInt iterations = 0;
    PetscReal change, divergence;
    PetscInt most;
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    CALL(KSPGetTolerances, system->solver, NULL, &change, &divergence, &most);
    CALL(KSPSetTolerances, system->solver, tolerance, change, divergence, most);
    CALL(KSPSetInitialGuessNonzero, system->solver, guess ? PETSC_TRUE : PETSC_FALSE);
    CALL(VecPlaceArray, system->right, b);
    CALL(VecPlaceArray, system->left, x);
    CALL(KSPSolve, system->solver, system->right, system->left);
    CALL(VecResetArray, system->right);
    CALL(VecResetArray, system->left);
    CALL(KSPGetIterationNumber, system->solver, &iterations);
    CALL(KSPGetConvergedReason, system->solver, &reason);
    outcome->iterations = iterations;
    outcome->converged = reason > 0;
    outcome->reason = KSPConvergedReasons[reason];
    return true;
}

bool petsc_solver_cycle(void *self, const double *r, double *z, struct error *error) {
    struct petsc_system *system = self;
    struct petsc_library *library = system->library;
    PC pc;
    CALL(KSPGetPC, system->solver, &pc);
    CALL(VecPlaceArray, system->right, r);
    CALL(VecPlaceArray, system->left, z);
    CALL(PCApply, pc, system->right, system->left);
    CALL(VecResetArray, system->right);
    CALL(VecResetArray, system->left);
    return true;
}
