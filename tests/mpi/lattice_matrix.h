/* SPDX-License-Identifier: BSD-3-Clause */
/* Matrices of lattices whose solutions can be checked from the rows: shared by the tests of src/physics/solve. */
#ifndef SCREE_TESTS_MPI_LATTICE_MATRIX_H
#define SCREE_TESTS_MPI_LATTICE_MATRIX_H

#include "physics/solve/solve.h"
#include "team.h"

enum { LATTICE_LINKS_MAX = 6 };

/* The negative Laplacian of a periodic lattice of `side` points in each direction, plus `shift` times one. Edges
 * weigh 1, or between 1 and 1 + spread; with `halves` no edge crosses the planes that divide the lattice, across
 * x, in two. The rows are dealt out evenly, and edge 24 is a multiple of all rank counts. */
struct lattice_matrix {
    int dimension, side;
    double spread, shift;
    bool halves;
    int32_t all, first, count; /* rows: of all, first of this rank, of this rank */
    int32_t *start, *column, *region;
    double *value;
};

/* Makes and frees the rows of this rank; dimension, side, spread, shift and halves are given. */
void lattice_matrix_make(struct lattice_matrix *lattice, const struct comm *comm);
void lattice_matrix_free(struct lattice_matrix *lattice);

/* The rows as the solver takes them; borrowed. */
struct solve_rows lattice_matrix_rows(const struct lattice_matrix *lattice);

/* A number in [0, 1) of two numbers in any order. */
double lattice_matrix_draw(int32_t a, int32_t b);

/* A right-hand side of random numbers in b, zeros in x. */
void lattice_matrix_sides(const struct lattice_matrix *lattice, double *b, double *x);

/* |b - A x| / |b| from the rows, without the pin. Collective. */
double lattice_matrix_residual(const struct lattice_matrix *lattice, const struct comm *comm, const double *b,
                               const double *x);

/* The largest mean of x over a region. Collective. */
double lattice_matrix_mean(const struct lattice_matrix *lattice, const struct comm *comm, const double *x);

/* Begins with options of PETSc; ends the test where PETSc is not there. NULL: failed, and noted. Collective. */
struct solve *lattice_matrix_begin(struct team *team, const char *options);

#endif
