/* SPDX-License-Identifier: BSD-3-Clause */
/* Jacobi's method, and the closed form of the largest eigenvalue. Read eigen3.h first. */
#include "base/eigen3.h"

#include <math.h>
#include <string.h>

/* Turns a and the axes so that a[p][q] vanishes. */
static void jacobi(double a[3][3], double axes[3][3], int p, int q) {
    if (a[p][q] == 0)
        return;
    double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double t = (theta >= 0 ? 1 : -1) / (fabs(theta) + sqrt(theta * theta + 1)), c = 1 / sqrt(t * t + 1),
           s = t * c;
    for (int k = 0; k < 3; k++) {
        double kp = a[k][p], kq = a[k][q];
        a[k][p] = c * kp - s * kq;
        a[k][q] = s * kp + c * kq;
    }
    for (int k = 0; k < 3; k++) {
        double pk = a[p][k], qk = a[q][k];
        a[p][k] = c * pk - s * qk;
        a[q][k] = s * pk + c * qk;
        double vp = axes[k][p], vq = axes[k][q];
        axes[k][p] = c * vp - s * vq;
        axes[k][q] = s * vp + c * vq;
    }
}

void eigen3_axes(const double matrix[9], double value[3], double turn[9]) {
    double a[3][3], axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    int order[3] = {0, 1, 2};
    memcpy(a, matrix, sizeof a);
    for (int sweep = 0; sweep < 30; sweep++)
        for (int p = 0; p < 2; p++)
            for (int q = p + 1; q < 3; q++)
                if (fabs(a[p][q]) > 1e-16 * (fabs(a[p][p]) + fabs(a[q][q])))
                    jacobi(a, axes, p, q);
    for (int k = 1; k < 3; k++) /* insertion sort keeps equal values in order */
        for (int m = k; m > 0 && a[order[m]][order[m]] < a[order[m - 1]][order[m - 1]]; m--) {
            int swap = order[m];
            order[m] = order[m - 1];
            order[m - 1] = swap;
        }
    for (int k = 0; k < 3; k++) {
        value[k] = a[order[k]][order[k]];
        for (int d = 0; d < 3; d++)
            turn[3 * d + k] = axes[d][order[k]];
    }
    double hand = turn[0] * (turn[4] * turn[8] - turn[5] * turn[7]) -
                  turn[1] * (turn[3] * turn[8] - turn[5] * turn[6]) +
                  turn[2] * (turn[3] * turn[7] - turn[4] * turn[6]);
    for (int d = 0; d < 3 && hand < 0; d++)
        turn[3 * d + 2] = -turn[3 * d + 2];
}

double eigen3_largest(const double m[6]) {
    double mean = (m[0] + m[1] + m[2]) / 3.0;
    double x = m[0] - mean, y = m[1] - mean, z = m[2] - mean;
    double off = m[3] * m[3] + m[4] * m[4] + m[5] * m[5];
    double size = sqrt((x * x + y * y + z * z + 2.0 * off) / 6.0);
    if (!(size > 1e-12 * fabs(mean)))
        return mean + 2.0 * size;
    double determinant =
        x * (y * z - m[5] * m[5]) - m[3] * (m[3] * z - m[5] * m[4]) + m[4] * (m[3] * m[5] - y * m[4]);
    double cosine = fmin(fmax(0.5 * determinant / (size * size * size), -1.0), 1.0);
    return mean + 2.0 * size * cos(acos(cosine) / 3.0);
}
