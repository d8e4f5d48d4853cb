/* SPDX-License-Identifier: BSD-3-Clause */
/* Calls of PETSc that name the function that failed, and options that the user has not set. */
#include "physics/solve/petsc_parts.h"

#include <stdio.h>
#include <string.h>

bool petsc_call(struct petsc_library *library, PetscErrorCode code, const char *call, struct error *error) {
    if (code == 0)
        return true;
    const char *text = NULL;
    PetscErrorMessage(code, &text, NULL);
    error_set(error, ERROR_SYSTEM, "%s of PETSc failed: %s (%s)", call, text ? text : "error",
              library->said[0] ? library->said : "no more is known");
    library->said[0] = '\0';
    return false;
}

bool petsc_preset(struct petsc_library *library, const char *prefix, const char *name, const char *value,
                  struct error *error) {
    char full[PETSC_NAME_MAX];
    PetscBool set = PETSC_FALSE;
    snprintf(full, sizeof full, "-%s%s", prefix, name);
    CALL(PetscOptionsHasName, NULL, NULL, full, &set);
    if (set || library->presets == PETSC_PRESETS_MAX)
        return true;
    CALL(PetscOptionsSetValue, NULL, full, value);
    memcpy(library->preset[library->presets++], full, sizeof full);
    return true;
}
