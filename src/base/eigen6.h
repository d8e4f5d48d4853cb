/* SPDX-License-Identifier: BSD-3-Clause */
/* The largest eigenvalue of a symmetric matrix of six rows: that of small motions of a rigid body. */
#ifndef SCREE_BASE_EIGEN6_H
#define SCREE_BASE_EIGEN6_H

/* Of a matrix row by row, by Jacobi's method. The result has errors of rounding, against the largest entry. Any thread. */
double eigen6_largest(const double matrix[36]);

#endif
