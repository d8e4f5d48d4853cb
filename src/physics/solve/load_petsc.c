/* SPDX-License-Identifier: BSD-3-Clause */
/* Loads the module with PETSc: beside the program or library that this code is part of (a build folder), or from
 * the folder where `make install` puts modules. */
#define _GNU_SOURCE
#include "physics/solve/backend.h"

#include <dlfcn.h>
#include <libgen.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define MODULE "libsolve_petsc.so"

bool solve_available(void) {
    return true;
}

/* `path` of the module in the folder `under` of the folder of this code, or one or two above; false without
 * one. */
static bool beside(char path[PATH_MAX]) {
    static const char *const places[] = {".libs", "../.libs", "../../.libs"};
    Dl_info info;
    char code[PATH_MAX];
    if (!dladdr((void *)solve_load, &info) || realpath(info.dli_fname, code) == NULL)
        return false;
    const char *folder = dirname(code);
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        int length = snprintf(path, PATH_MAX, "%s/%s/" MODULE, folder, places[k]);
        if (length < PATH_MAX && access(path, R_OK) == 0)
            return true;
    }
    return false;
}

const struct solve_backend *solve_load(struct error *error) {
    char path[PATH_MAX];
    if (!beside(path))
        snprintf(path, sizeof path, "%s/" MODULE, SCREE_MODULES);
    /* never unloaded: PETSc leaves callbacks with MPI */
    void *module = dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    const struct solve_backend *backend = module ? dlsym(module, "petsc_backend") : NULL;
    if (backend == NULL)
        error_set(error, ERROR_SYSTEM, "PETSc, which solves systems of equations, cannot be loaded: %s",
                  dlerror());
    return backend;
}
