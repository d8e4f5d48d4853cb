/* SPDX-License-Identifier: BSD-3-Clause */
/* Moving least squares: around a particle i a polynomial of order m is fitted to the values at i and at its
 * neighbours, each weighted by the kernel, and its derivatives at i are the operators (Lancaster, Salkauskas, Math.
 * Comput. 37 (1981) 141). With the monomials p of xi = (x_j - x_i) / scale up to order m, i itself among the j:
 *
 *   M = sum W_ij p(xi_ij) p(xi_ij)^T,     weight_ij = (D p)(0)^T M^-1 p(xi_ij) W_ij    for a derivative D
 *
 * As constants are reproduced, the weights of all j, i included, add up to 0: so they act on differences f_j - f_i, as
 * those of correction_tensors.h do. The gradient is exact for polynomials of order m, and so is the Laplacian, for m >= 2. */
#ifndef SCREE_OPERATORS_MLS_H
#define SCREE_OPERATORS_MLS_H

#include "physics/fluid/operators/correction_tensors.h"

enum { MLS_ORDER_MAX = 4, MLS_TERMS_MAX = 35 };

struct mls_options {
    int order;     /* m, 1 ... MLS_ORDER_MAX */
    int dimension; /* 2 or 3 */
    double scale;  /* length of the size of the support */
    double own;    /* W(0) */
};

/* Number of monomials up to an order. */
int mls_terms(int order, int dimension);

/* The weights of `count` neighbours, of which distance, e and value are read: those of the gradient to vector
 * (`dimension` a neighbour), those of the Laplacian to scalar; with order 1 scalar stays as it is. False, with nothing
 * written, if the neighbours are too few or so placed that they do not determine the polynomial. Any thread. */
bool mls_weigh(const struct mls_options *options, const struct correction_tensors_neighbour *neighbour,
               size_t count, double *vector, double *scalar);

#endif
