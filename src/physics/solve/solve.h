/* SPDX-License-Identifier: BSD-3-Clause */
/* Systems of linear equations on all ranks. The library behind this header is PETSc (petsc.c and its
 * neighbours, the only files that include PETSc). PETSc brings a hundred shared libraries, so these files are
 * a module, which the program loads when a run first asks for a solver (load_petsc.c): a run without a fluid does not
 * see PETSc at all. A build without PETSc has no module (missing.c), and solve_begin says so.
 *
 * Matrices come as rows in compressed form with global columns; the ranks own contiguous ranges of rows, in
 * rank order. Threads fill rows and values; the functions here are called by one thread of each rank. All
 * functions but those named otherwise are collective.
 *
 * A failure inside the library on one rank leaves the others waiting, so it ends all ranks, and the message
 * names the rank and the call. A wrong option is the user's mistake on all ranks alike, and comes back as an
 * error. A solver that does not converge is no error here: the report says so.
 *
 * The order of calls: solve_begin; solve_create, solve_null_space; solve_solve as often as needed, with
 * solve_values in between where values change; solve_destroy; solve_end. */
#ifndef SCREE_SOLVE_SOLVE_H
#define SCREE_SOLVE_SOLVE_H

#include "kernel/comm/comm.h"
#include "base/timer.h"

/* True if the program was built with PETSc. Not collective. */
bool solve_available(void);

/* Names of the preconditioners and Krylov methods, comma separated, for messages. Not collective. */
const char *solve_preconditioners(void);
const char *solve_methods(void);

struct solve; /* the library, ready for use */

/* Starts the library on the ranks of `comm` (borrowed until solve_end): no signal handlers, nothing read from
 * the command line. `options`, which may be NULL, is a text of PETSc's options ("-fluid_p_ksp_monitor
 * ..."); PETSc adds those of PETSC_OPTIONS. Returns NULL and fills `error` if the library is missing or
 * refuses an option. */
struct solve *solve_begin(const struct comm *comm, const char *options, struct error *error);

/* Charges the time in which matrices are handed over, preconditioners made and systems solved to the stages "assembly",
 * "preconditioner" and "solve" of `timers` (borrowed), as far as there are such. Not collective. */
void solve_charge(struct solve *solve, struct timers *timers);

/* Ends the library; all systems must have been destroyed. `unused`, which may be NULL, gets the options of
 * the user that nothing has asked for, separated by spaces; "" if there are none. */
void solve_end(struct solve **solve, char *unused, size_t size);

/* The rows of this rank. Borrowed during the call. */
struct solve_rows {
    int32_t count;         /* rows, and unknowns, of this rank */
    const int32_t *start;  /* count + 1: first entry of each row */
    const int32_t *column; /* global, increasing within a row, the diagonal included */
    const double *value;
};

struct solve_options {
    const char *prefix;         /* of PETSc's options for this system: "fluid_p_" */
    const char *method;         /* fgmres, gmres, lgmres, bicgstab or cg */
    const char *preconditioner; /* boomeramg, gamg, ml, ilu, sor, jacobi or none */
    double tolerance;           /* of |b - A x| / |b| */
    int iterations;             /* at most */
    int restart; /* iterations of a cycle, and vectors, of fgmres, gmres and lgmres; lgmres has some more for `augment` */
    int augment; /* lgmres: corrections of earlier cycles among the directions of a cycle, once there are so many */
    double pin; /* the diagonal is multiplied by 1 + pin; 0: none. For singular matrices 1e-9 */
    /* A preconditioner serves the matrix for which it was made, and after new values so many times more; 0: none.
     * It is made again sooner if a solve took more than half as many iterations again as the first one with it. */
    int reuse;
    /* The preconditioner takes the matrix over where it would keep a copy: solve_values must not follow. */
    bool given_up;
};

/* The options of a system whose matrix is singular (pressure: FGMRES, BoomerAMG, pin 1e-9) and of one that is
 * not (velocity: BiCGStab, Jacobi). The prefix is borrowed. */
struct solve_options solve_options_singular(const char *prefix);
struct solve_options solve_options_regular(const char *prefix);

/* A solve whose true residual is above so many tolerances is doubtful. */
#define SOLVE_DOUBT 10.0

/* The course of a system so far. */
struct solve_report {
    int iterations;        /* of the last solve */
    bool converged;        /* the last solve */
    const char *reason;    /* the end of the last solve, in a word of PETSc's; static text */
    double residual;       /* |b - A x| / |b| of the last solve, computed from the pinned A, b and x */
    double tolerance;      /* of the last solve */
    double residual_worst; /* the largest so far */
    int64_t solves, set_ups, iterations_all;
    int64_t kept;     /* solves after new values for which the old preconditioner was kept */
    int64_t doubtful; /* solves with a residual above SOLVE_DOUBT tolerances, where these alone end a solve */
    double doubt;     /* the largest residual over its tolerance */
    int64_t rows, entries; /* of the matrix, all ranks together; 0 entries: without a matrix */
    int64_t products;      /* of the matrix with a vector, for residuals; seconds_products is theirs */
    double seconds_matrix, seconds_set_up, seconds_solve, seconds_products; /* in all, of this rank */
};

struct solve_system;

/* Makes a matrix with its solver; `rows` may be released afterwards. The rank with the lowest number owns the
 * first rows. Returns NULL and fills `error` if an option has no meaning. */
struct solve_system *solve_create(struct solve *solve, const struct solve_rows *rows,
                                  const struct solve_options *options, struct error *error);
void solve_destroy(struct solve_system **system);

/* Replaces the values, given in the order of the rows of solve_create. */
void solve_values(struct solve_system *system, const double *value);

/* States that each constant on one of the `regions` (1 ... SOLVE_REGIONS_MAX) solves A x = 0. region[row]
 * (borrowed during the call) is the number of the region of a row of this rank; NULL with one region. From now
 * on solve_solve subtracts the mean over each region from b, and from the result. */
enum { SOLVE_REGIONS_MAX = 256 };
void solve_null_space(struct solve_system *system, int regions, const int32_t *region);

/* Makes the preconditioner now, if a solve would. */
void solve_prepare(struct solve_system *system);

/* The next solve makes its preconditioner, whatever `reuse` says. Not collective, but alike on all ranks. */
void solve_renew(struct solve_system *system);

/* Sets the tolerance of the solves that follow. Not collective, but alike on all ranks. */
void solve_tolerance(struct solve_system *system, double tolerance);

/* Solves A x = b. x is the first guess, or not looked at where `guess` is false. The means of b over regions are
 * subtracted in place. That makes b consistent if the columns of A sum to zero, as on a lattice; else no x solves A x = b.
 * With a pin the solver then finds the x that solves A x = b - g D, with the diagonal D of A and one number g a region: g D
 * is the pinned matrix times a constant, which is no part of the result, but of the residual that is reported. Returns
 * true if the solver converged to the tolerance; the report says more. */
bool solve_solve(struct solve_system *system, double *b, double *x, bool guess);

/* y = A x, with the pinned diagonal. z = one application of the system's preconditioner to r. */
void solve_multiply(struct solve_system *system, const double *x, double *y);
void solve_cycle(struct solve_system *system, const double *r, double *z);

/* Borrowed. Not collective. */
const struct solve_report *solve_report(const struct solve_system *system);

/* The course of all systems with a prefix together, also of those that are no more; what concerns the last solve is
 * that of the last solve of any. Zeros without such a system. Borrowed. Not collective. */
enum { SOLVE_PREFIXES_MAX = 8 };
const struct solve_report *solve_total(const struct solve *solve, const char *prefix);

/* A system without a matrix: callbacks say what operator and preconditioner do to `count` numbers of this
 * rank, and when to end. They get `context`; they are collective. */
struct solve_free {
    int32_t count;
    void *context;
    void (*multiply)(void *context, const double *x, double *y);     /* y = A x */
    void (*precondition)(void *context, const double *r, double *z); /* z = an approximate A^-1 r */
    /* NULL: only the tolerance ends the solve. Called each `every` iterations with the present x; true ends the
     * solve, converged. */
    bool (*enough)(void *context, int iteration, const double *x, double residual);
    int every;
};
struct solve_system *solve_create_free(struct solve *solve, const struct solve_free *work,
                                       const struct solve_options *options, struct error *error);

#endif
