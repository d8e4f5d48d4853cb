/* SPDX-License-Identifier: BSD-3-Clause */
/* Jacobi's method for six rows. Read eigen6.h first. */
#include "base/eigen6.h"
#include <math.h>
#include <string.h>

enum { ROWS = 6 };

/* Turns a so that a[p][q] vanishes. */
static void jacobi(double a[ROWS][ROWS], int p, int q) {
    double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double t = (theta >= 0 ? 1 : -1) / (fabs(theta) + sqrt(theta * theta + 1)), c = 1 / sqrt(t * t + 1),
           s = t * c;
    for (int k = 0; k < ROWS; k++) {
        double kp = a[k][p], kq = a[k][q];
        a[k][p] = c * kp - s * kq;
        a[k][q] = s * kp + c * kq;
    }
    for (int k = 0; k < ROWS; k++) {
        double pk = a[p][k], qk = a[q][k];
        a[p][k] = c * pk - s * qk;
        a[q][k] = s * pk + c * qk;
    }
}

double eigen6_largest(const double matrix[36]) {
    double a[ROWS][ROWS], most = -INFINITY;
    memcpy(a, matrix, sizeof a);
    for (int sweep = 0; sweep < 30; sweep++)
        for (int p = 0; p < ROWS - 1; p++)
            for (int q = p + 1; q < ROWS; q++)
                if (fabs(a[p][q]) > 1e-16 * (fabs(a[p][p]) + fabs(a[q][q])))
                    jacobi(a, p, q);
    for (int k = 0; k < ROWS; k++)
        most = fmax(most, a[k][k]);
    return most;
}
