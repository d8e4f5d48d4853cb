/* SPDX-License-Identifier: BSD-3-Clause */
/* Inverts N of each row by its eigenvectors. Read gradient_correction.h first. */
#include "physics/fluid/operators/gradient_correction.h"

enum { SWEEPS = 12 };

/* One turn of Jacobi's method: makes n[p][q] of a symmetric matrix 0; the columns of v are the vectors. */
static void turn(double n[3][3], double v[3][3], int p, int q) {
    if (n[p][q] == 0)
        return;
    double angle = 0.5 * atan2(2 * n[p][q], n[q][q] - n[p][p]), c = cos(angle), s = sin(angle);
    for (int k = 0; k < 3; k++) {
        double a = n[k][p], b = n[k][q];
        n[k][p] = c * a - s * b;
        n[k][q] = s * a + c * b;
    }
    for (int k = 0; k < 3; k++) {
        double a = n[p][k], b = n[q][k], x = v[k][p], y = v[k][q];
        n[p][k] = c * a - s * b;
        n[q][k] = s * a + c * b;
        v[k][p] = c * x - s * y;
        v[k][q] = s * x + c * y;
    }
}

/* out = 1 / n of a symmetric matrix, with eigenvalues of WHOLE_LEAST at least. */
static void invert(double n[3][3], double out[9]) {
    double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        for (int p = 0; p < 2; p++)
            for (int q = p + 1; q < 3; q++)
                turn(n, v, p, q);
    for (int d = 0; d < 3; d++)
        for (int e = 0; e < 3; e++) {
            out[3 * d + e] = 0;
            for (int k = 0; k < 3; k++)
                out[3 * d + e] += v[d][k] * v[e][k] / fmax(n[k][k], WHOLE_LEAST);
        }
}

void gradient_correction_make(const struct weights *weights, const struct weights_input *rows,
                              double (*whole)[9]) {
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        double n[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, apart[3];
        size_t e = weights_walls(weights, row);
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
            if (weights_foot_of(weights, k)->open)
                continue;
            const double *b = weights_vector(weights, e);
            weights_apart(weights, rows, row, e, apart);
            for (int p = 0; p < weights->dimension; p++)
                for (int q = 0; q < weights->dimension; q++)
                    n[p][q] -= 0.5 * (b[p] * apart[q] + b[q] * apart[p]);
        }
        invert(n, whole[weights->first + row]);
    }
}
