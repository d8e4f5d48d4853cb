/* SPDX-License-Identifier: BSD-3-Clause */
/* Eigenvalues and axes of symmetric matrices of three rows. */
#ifndef SCREE_BASE_EIGEN3_H
#define SCREE_BASE_EIGEN3_H

/* Eigenvalues, from small to large, of a symmetric matrix (row by row), and its axes as the columns of a rotation: Jacobi's
 * method. The result has errors of rounding, against the largest eigenvalue. */
void eigen3_axes(const double matrix[9], double value[3], double turn[9]);

/* The largest eigenvalue of a symmetric matrix xx yy zz xy xz yz, in closed form: an acos and a cos. Where the two largest
 * are equal, the error is up to 1e-8 of them; else one of rounding. */
double eigen3_largest(const double m[6]);

#endif
