/* SPDX-License-Identifier: BSD-3-Clause */
/* Systems without a matrix: PETSc calls back to multiply, to precondition and to ask whether to go on. */
#include "physics/solve/petsc_parts.h"

static PetscErrorCode multiply(Mat matrix, Vec x, Vec y) {
    struct petsc_system *system;
    const PetscScalar *in;
    PetscScalar *out;
    PetscCall(MatShellGetContext(matrix, &system));
    PetscCall(VecGetArrayRead(x, &in));
    PetscCall(VecGetArray(y, &out));
    system->work.multiply(system->work.context, in, out);
    PetscCall(VecRestoreArray(y, &out));
    PetscCall(VecRestoreArrayRead(x, &in));
    return 0;
}

static PetscErrorCode precondition(PC pc, Vec r, Vec z) {
    struct petsc_system *system;
    const PetscScalar *in;
    PetscScalar *out;
    PetscCall(PCShellGetContext(pc, &system));
    PetscCall(VecGetArrayRead(r, &in));
    PetscCall(VecGetArray(z, &out));
    system->work.precondition(system->work.context, in, out);
    PetscCall(VecRestoreArray(z, &out));
    PetscCall(VecRestoreArrayRead(r, &in));
    return 0;
}

/* PETSc's own test, and each so many iterations the question to the caller, with the solution as it is now. Where GMRES
 * starts again PETSc tests an iteration twice; the caller, who may compare with the solution before, is asked once. */
static PetscErrorCode decide(KSP solver, PetscInt iteration, PetscReal residual, KSPConvergedReason *reason,
                             void *context) {
    struct petsc_system *system = context;
    const PetscScalar *x;
    Vec solution;
    PetscCall(KSPConvergedDefault(solver, iteration, residual, reason, system->test));
    if (iteration == 0)
        system->asked = 0;
    if (*reason != KSP_CONVERGED_ITERATING || iteration == system->asked ||
        iteration % system->work.every != 0)
        return 0;
    system->asked = iteration;
    PetscCall(KSPBuildSolution(solver, NULL, &solution));
    PetscCall(VecGetArrayRead(solution, &x));
    if (system->work.enough(system->work.context, (int)iteration, x, residual))
        *reason = KSP_CONVERGED_ITS;
    PetscCall(VecRestoreArrayRead(solution, &x));
    return 0;
}

static PetscErrorCode forget(void *context) {
    struct petsc_system *system = context;
    return KSPConvergedDefaultDestroy(system->test);
}

bool petsc_free_make(struct petsc_system *system, struct error *error) {
    struct petsc_library *library = system->library;
    CALL(MatCreateShell, library->comm->handle, system->count, system->count, PETSC_DETERMINE,
         PETSC_DETERMINE, system, &system->matrix);
    CALL(MatShellSetOperation, system->matrix, MATOP_MULT, (void (*)(void))multiply);
    return true;
}

bool petsc_free_end(struct petsc_system *system, struct error *error) {
    struct petsc_library *library = system->library;
    PC pc;
    CALL(KSPGetPC, system->solver, &pc);
    CALL(PCSetType, pc, PCSHELL);
    CALL(PCShellSetContext, pc, system);
    CALL(PCShellSetApply, pc, precondition);
    if (system->work.enough == NULL)
        return true;
    CALL(KSPConvergedDefaultCreate, &system->test);
    CALL(KSPSetConvergenceTest, system->solver, decide, system, forget);
    return true;
}
