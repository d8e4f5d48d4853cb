/* SPDX-License-Identifier: BSD-3-Clause */
/* Inverts N of each row by its eigenvectors. Read gradient_correction.h first. */
#include "physics/fluid/operators/gradient_correction.h"
#include "base/eigen3.h"

/* out = 1 / n of a symmetric matrix, with eigenvalues of WHOLE_LEAST at least. */
static void invert(const double n[9], double out[9]) {
    double value[3], axes[9];
    eigen3_axes(n, value, axes);
    for (int d = 0; d < 3; d++)
        for (int e = 0; e < 3; e++) {
            out[3 * d + e] = 0;
            for (int k = 0; k < 3; k++)
                out[3 * d + e] += axes[3 * d + k] * axes[3 * e + k] / fmax(value[k], WHOLE_LEAST);
        }
}

void gradient_correction_make(const struct weights *weights, const struct weights_input *rows,
                              double (*whole)[9]) {
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        double n[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, apart[3];
        size_t e = weights_walls(weights, row);
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
            if (weights_foot_of(weights, k)->open)
                continue;
            const double *b = weights_vector(weights, e);
            weights_apart(weights, rows, row, e, apart);
            for (int p = 0; p < weights->dimension; p++)
                for (int q = 0; q < weights->dimension; q++)
                    n[3 * p + q] -= 0.5 * (b[p] * apart[q] + b[q] * apart[p]);
        }
        invert(n, whole[weights->first + row]);
    }
}
