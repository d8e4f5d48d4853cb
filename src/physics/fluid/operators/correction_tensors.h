/* SPDX-License-Identifier: BSD-3-Clause */
/* The correction tensors of one particle, and the weights that follow from them. With r = x_i - x_j, e = r / |r|,
 * W' = dW/dr, V the volume of the neighbour and sums over all neighbours, fluid and wall:
 *
 *   M^sq = -sum V W' r^s e^q,    G = inverse of M,    b^k = V W' G^kq e^q
 *   A^kmn = sum b^k r^m r^n
 *   S^mn,op = sum V W' (A^kmn e^k + r^m e^n) e^o e^p (2 - delta^op),  m <= n, o <= p;    S L = -delta
 *   a = 2 V W' (L : e e),  c = sum a e,  w = -a / |r| - c . b
 *
 * (Bonet and Lok 1999; Fatehi and Manzari 2011; Trask et al. 2015: weights.h.) b is exact for linear, w for
 * quadratic functions. The standard operators have G = 1, L = 1 and no c. */
#ifndef SCREE_OPERATORS_CORRECTION_TENSORS_H
#define SCREE_OPERATORS_CORRECTION_TENSORS_H

#include <stdbool.h>
#include <stddef.h>

enum { TENSORS_TWO = 6 }; /* the components mn with m <= n: xx yy zz xy xz yz; in two dimensions xx yy xy */

/* A neighbour. */
struct correction_tensors_neighbour {
    double strength; /* V W', 1 / length */
    double value;    /* W; not read here (mls.h) */
    double distance; /* |r| > 0 */
    double e[3];     /* r / |r|; e[2] is 0 in two dimensions */
};

struct tensors {
    double gradient[3][3];         /* G */
    double laplacian[TENSORS_TWO]; /* L */
    double rest[3];                /* c */
    double condition;              /* |M| |G| / dimension, Frobenius norms; 0: standard operators */
};

/* Computes the tensors of `count` neighbours in 2 or 3 dimensions. False if M or S is singular, as with too few or
 * collinear neighbours: then the tensors are those of the standard operators. Any thread. */
bool correction_tensors_make(struct tensors *tensors, const struct correction_tensors_neighbour *neighbour,
                             size_t count, int dimension);

/* The tensors of the standard operators. */
void correction_tensors_standard(struct tensors *tensors, int dimension);

/* The weights of a neighbour: b to vector[dimension]; returns w. */
double correction_tensors_weigh(const struct tensors *tensors,
                                const struct correction_tensors_neighbour *neighbour, int dimension,
                                double *vector);

#endif
