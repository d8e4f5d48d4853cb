/* SPDX-License-Identifier: BSD-3-Clause */
/* The functions of the library behind solve.h, which a module exports as one table, `petsc_backend`. system.c
 * calls them, and nobody else. A function that fails fills `error`: ERROR_USER if all ranks fail alike
 * because of an option, ERROR_SYSTEM otherwise. Functions that return a pointer return NULL then, others
 * false. */
#ifndef SCREE_SOLVE_BACKEND_H
#define SCREE_SOLVE_BACKEND_H

#include "physics/solve/solve.h"

/* The end of one solve. */
struct solve_outcome {
    int iterations;
    bool converged;
    const char *reason; /* static text */
};

struct solve_backend {
    void *(*begin)(const struct comm *comm, const char *options, struct error *error);
    void (*end)(void *library, char *unused, size_t size);
    void *(*create)(void *library, const struct solve_rows *rows, const struct solve_options *options,
                    struct error *error);
    void *(*create_free)(void *library, const struct solve_free *work, const struct solve_options *options,
                         struct error *error);
    void (*destroy)(void *system);
    bool (*values)(void *system, const double *value, struct error *error);
    bool (*null_space)(void *system, int regions, const int32_t *region, const double *sizes,
                       struct error *error);
    /* Makes the preconditioner, or keeps the old one with the new values of the matrix. */
    bool (*set_up)(void *system, bool keep, struct error *error);
    bool (*solve)(void *system, const double *b, double *x, bool guess, double tolerance,
                  struct solve_outcome *outcome, struct error *error);
    bool (*multiply)(void *system, const double *x, double *y, struct error *error);
    bool (*cycle)(void *system, const double *r, double *z, struct error *error);
};

/* Finds the module; NULL, with an error that names the missing package, if there is none. */
const struct solve_backend *solve_load(struct error *error);

#endif
