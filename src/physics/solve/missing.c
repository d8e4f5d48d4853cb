/* SPDX-License-Identifier: BSD-3-Clause */
/* A build without PETSc. */
#include "physics/solve/backend.h"

bool solve_available(void) {
    return false;
}

const struct solve_backend *solve_load(struct error *error) {
    error_set(error, ERROR_USER,
              "this scree was built without PETSc, which solves systems of equations: install it (Debian: "
              "libpetsc-real-dev), then configure and build again");
    return NULL;
}
