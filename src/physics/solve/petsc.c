/* SPDX-License-Identifier: BSD-3-Clause */
/* PETSc's start, end, options and errors, and the table by which system.c finds all. Read backend.h first. */
#include "physics/solve/petsc_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* PETSc tells every function on its way up; the first text says what happened. */
static PetscErrorCode note_error(MPI_Comm comm, int line, const char *function, const char *file,
                                 PetscErrorCode code, PetscErrorType type, const char *text, void *context) {
    struct petsc_library *library = context;
    (void)comm, (void)line, (void)file;
    if (type == PETSC_ERROR_INITIAL || library->said[0] == '\0')
        snprintf(library->said, sizeof library->said, "%s in %s", text ? text : "error", function);
    return code;
}

static bool start(struct petsc_library *library, const char *options, struct error *error) {
    PetscBool started = PETSC_FALSE;
    char *words[] = {"scree", "-no_signal_handler", "-options_left", "no", NULL}, **arguments = words;
    int count = 4;
    CALL(PetscInitialized, &started);
    library->ours = !started;
    if (library->ours) {
        PETSC_COMM_WORLD = library->comm->handle;
        CALL(PetscInitialize, &count, &arguments, NULL, NULL);
    }
    CALL(PetscPushErrorHandler, note_error, library);
    if (options != NULL &&
        !petsc_call(library, PetscOptionsInsertString(NULL, options), "PetscOptionsInsertString", error))
        error->kind = ERROR_USER;
    return error->kind == ERROR_NONE;
}

static void *begin(const struct comm *comm, const char *options, struct error *error) {
    struct petsc_library *library = calloc(1, sizeof *library);
    if (library == NULL) {
        error_set(error, ERROR_SYSTEM, "no memory for PETSc");
        return NULL;
    }
    library->comm = comm;
    if (start(library, options, error))
        return library;
    free(library);
    return NULL;
}

/* Is an option, named without its dash, one of this module? */
static bool is_preset(const struct petsc_library *library, const char *name) {
    static const char *const ours[] = {"no_signal_handler", "options_left"};
    for (size_t k = 0; k < sizeof ours / sizeof *ours; k++)
        if (strcmp(name, ours[k]) == 0)
            return true;
    for (int k = 0; k < library->presets; k++)
        if (strcmp(name, library->preset[k] + 1) == 0)
            return true;
    return false;
}

static void list_unused(struct petsc_library *library, char *unused, size_t size) {
    PetscInt count = 0;
    char **names = NULL, **values = NULL;
    size_t used = 0;
    if (PetscOptionsLeftGet(NULL, &count, &names, &values) != 0)
        return;
    for (PetscInt k = 0; k < count; k++) {
        if (is_preset(library, names[k]) || used >= size)
            continue;
        int length = snprintf(unused + used, size - used, "%s-%s", used ? " " : "", names[k]);
        used += length > 0 ? (size_t)length : 0;
    }
    PetscOptionsLeftRestore(NULL, &count, &names, &values);
}

static void end(void *self, char *unused, size_t size) {
    struct petsc_library *library = self;
    if (unused != NULL && size > 0) {
        unused[0] = '\0';
        list_unused(library, unused, size);
    }
    for (int k = 0; k < library->presets; k++)
        PetscOptionsClearValue(NULL, library->preset[k]);
    PetscPopErrorHandler();
    if (library->ours)
        PetscFinalize();
    free(library);
}

static void destroy(void *self) {
    struct petsc_system *system = self;
    KSPDestroy(&system->solver);
    MatDestroy(&system->matrix);
    VecDestroy(&system->left);
    VecDestroy(&system->right);
    free(system);
}

/* An empty system of `count` rows on this rank; NULL with an error without memory. */
static struct petsc_system *begin_system(void *library, int32_t count, struct error *error) {
    struct petsc_system *system = calloc(1, sizeof *system);
    if (system == NULL) {
        error_set(error, ERROR_SYSTEM, "no memory for a linear system");
        return NULL;
    }
    system->library = library;
    system->count = count;
    return system;
}

/* The vectors of a system, which borrow arrays; an array on one rank and more is the same kind of vector. */
static bool make_vectors(struct petsc_system *system, struct error *error) {
    struct petsc_library *library = system->library;
    MPI_Comm comm = library->comm->handle;
    CALL(VecCreateMPIWithArray, comm, 1, system->count, PETSC_DETERMINE, NULL, &system->left);
    CALL(VecCreateMPIWithArray, comm, 1, system->count, PETSC_DETERMINE, NULL, &system->right);
    return true;
}

static void *create(void *library, const struct solve_rows *rows, const struct solve_options *options,
                    struct error *error) {
    struct petsc_system *system = begin_system(library, rows->count, error);
    if (system == NULL)
        return NULL;
    system->pin = options->pin;
    if (make_vectors(system, error) && petsc_matrix_make(system, rows, error) &&
        petsc_solver_make(system, options, error))
        return system;
    destroy(system);
    return NULL;
}

static void *create_free(void *library, const struct solve_free *work, const struct solve_options *options,
                         struct error *error) {
    struct petsc_system *system = begin_system(library, work->count, error);
    if (system == NULL)
        return NULL;
    system->work = *work;
    if (make_vectors(system, error) && petsc_free_make(system, error) &&
        petsc_solver_make(system, options, error) && petsc_free_end(system, error))
        return system;
    destroy(system);
    return NULL;
}

const struct solve_backend petsc_backend = {.begin = begin,
                                            .end = end,
                                            .create = create,
                                            .create_free = create_free,
                                            .destroy = destroy,
                                            .values = petsc_matrix_values,
                                            .null_space = petsc_matrix_null_space,
                                            .set_up = petsc_solver_set_up,
                                            .solve = petsc_solver_solve,
                                            .multiply = petsc_matrix_multiply,
                                            .cycle = petsc_solver_cycle};
