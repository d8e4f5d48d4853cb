/* SPDX-License-Identifier: BSD-3-Clause */
/* The kinds of failure, and the one way each is reported.
 *
 * A function that can fail because of the user or of the system takes a `struct error *` as its last
 * argument, fills it and returns false. Nobody below `src/front` prints or exits: the caller decides, and under
 * MPI `comm_agree` turns the error of one rank into the same error on all of them, so that exactly one
 * message appears. A programmer's mistake is an assert. Only an error that cannot be reported upwards (memory
 * exhausted in a thread, a failed MPI call) goes through `error_fatal`.
 */
#ifndef SCREE_BASE_ERROR_H
#define SCREE_BASE_ERROR_H

#include <stdbool.h>

struct log;

enum { ERROR_TEXT_MAX = 2048 };

enum error_kind {
    ERROR_NONE = 0,
    ERROR_SYSTEM = 1,  /* MPI, HDF5, memory, disk: exit status 1 */
    ERROR_USER = 2,    /* scene, data, mesh, checkpoint, command line: exit status 2 */
    ERROR_PHYSICS = 3, /* a guard stopped the run: exit status 3 */
    ERROR_SIGNAL = 128 /* plus the signal's number: a signal ended the run: exit status 128 + number */
};

struct error {
    enum error_kind kind; /* also the exit status of the program */
    char text[ERROR_TEXT_MAX];
};

/* Fills `error` with a kind and a printf-style text (no newline at the end; for a user's mistake: file, line,
 * key and the allowed values). The first error wins: a filled `error` is left alone. `error` may not be NULL.
 * Returns false always, so that a caller can write `return error_set(...)`. */
bool error_set(struct error *error, enum error_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* As error_set with kind ERROR_SYSTEM, with ": " and the text of the present errno appended. */
bool error_set_errno(struct error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Prints "scree: rank R: TEXT" to stderr and ends the program with status 1 through the abort hook. For
 * failures that cannot be handed upwards; may be called from any thread. */
_Noreturn void error_fatal(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Sets the rank named in fatal messages and the function that ends the program (NULL: abort()). `comm_start`
 * sets MPI_Abort, and `comm_stop` removes MPI_Abort again. Before `comm_start` the rank is 0 and the function
 * is abort(). One thread. */
void error_set_abort(int rank, void (*abort_hook)(int status));

/* Sets the receiver of fatal messages, which is copied; NULL: standard error. One thread. */
void error_set_log(const struct log *log);

#endif
