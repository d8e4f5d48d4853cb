/* SPDX-License-Identifier: BSD-3-Clause */
/* The correction tensors of one particle, with a small dense solver. Read correction_tensors.h first. */
#include "physics/fluid/operators/correction_tensors.h"
#include <math.h>
#include <string.h>

/* A pivot below this part of the largest entry counts as zero. */
#define SINGULAR 1e-7

/* The pairs (m, n) of the packed components, for 2 and 3 dimensions. */
static const int first_of[2][TENSORS_TWO] = {{0, 1, 0}, {0, 1, 2, 0, 0, 1}};
static const int second_of[2][TENSORS_TWO] = {{0, 1, 1}, {0, 1, 2, 1, 2, 2}};

static int packed_count(int dimension) {
    return dimension == 2 ? 3 : 6;
}

static void row_swap(double *a, double *b, int n) {
    for (int k = 0; k < n; k++) {
        double kept = a[k];
        a[k] = b[k];
        b[k] = kept;
    }
}

/* Solves for `sides` right-hand sides that stand behind the n columns of the matrix, `width` doubles a row. The
 * solutions take the places of the right-hand sides. Gauss-Jordan with partial pivots. */
static bool solve(double *matrix, int n, int width) {
    double most = 0;
    for (int r = 0; r < n; r++)
        for (int k = 0; k < n; k++)
            most = fmax(most, fabs(matrix[r * width + k]));
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int r = k + 1; r < n; r++)
            if (fabs(matrix[r * width + k]) > fabs(matrix[best * width + k]))
                best = r;
        if (!(fabs(matrix[best * width + k]) > SINGULAR * most))
            return false;
        row_swap(matrix + best * width, matrix + k * width, width);
        for (int r = 0; r < n; r++) {
            double factor = matrix[r * width + k] / matrix[k * width + k];
            for (int q = k; q < width && r != k; q++)
                matrix[r * width + q] -= factor * matrix[k * width + q];
        }
    }
    for (int r = 0; r < n; r++)
        for (int q = n; q < width; q++)
            matrix[r * width + q] /= matrix[r * width + r];
    return true;
}

void correction_tensors_standard(struct tensors *tensors, int dimension) {
    *tensors = (struct tensors){0};
    for (int d = 0; d < dimension; d++)
        tensors->gradient[d][d] = tensors->laplacian[d] = 1;
}

static bool gradient_make(struct tensors *tensors, const struct correction_tensors_neighbour *neighbour,
                          size_t count, int dimension) {
    double matrix[3 * 6] = {0};
    int width = 2 * dimension;
    for (size_t j = 0; j < count; j++) {
        const struct correction_tensors_neighbour *to = &neighbour[j];
        for (int s = 0; s < dimension; s++)
            for (int q = 0; q < dimension; q++)
                matrix[s * width + q] -= to->strength * to->distance * to->e[s] * to->e[q];
    }
    double size[2] = {0};
    for (int s = 0; s < dimension; s++)
        for (int q = 0; q < dimension; q++)
            size[0] += matrix[s * width + q] * matrix[s * width + q];
    for (int d = 0; d < dimension; d++)
        matrix[d * width + dimension + d] = 1;
    if (!solve(matrix, dimension, width))
        return false;
    for (int s = 0; s < dimension; s++)
        for (int q = 0; q < dimension; q++) {
            tensors->gradient[s][q] = matrix[s * width + dimension + q];
            size[1] += tensors->gradient[s][q] * tensors->gradient[s][q];
        }
    tensors->condition = sqrt(size[0] * size[1]) / dimension;
    return true;
}

/* b^k = V W' G^kq e^q. */
static void vector_weigh(const struct tensors *tensors, const struct correction_tensors_neighbour *to,
                         int dimension, double *vector) {
    for (int k = 0; k < dimension; k++) {
        vector[k] = 0;
        for (int q = 0; q < dimension; q++)
            vector[k] += to->strength * tensors->gradient[k][q] * to->e[q];
    }
}

/* A^kmn, packed in mn. */
static void third_make(double third[3][TENSORS_TWO], const struct tensors *tensors,
                       const struct correction_tensors_neighbour *neighbour, size_t count, int dimension) {
    const int *first = first_of[dimension - 2], *second = second_of[dimension - 2];
    memset(third, 0, 3 * sizeof *third);
    for (size_t j = 0; j < count; j++) {
        const struct correction_tensors_neighbour *to = &neighbour[j];
        double b[3], square = to->distance * to->distance;
        vector_weigh(tensors, to, dimension, b);
        for (int k = 0; k < dimension; k++)
            for (int mn = 0; mn < packed_count(dimension); mn++)
                third[k][mn] += b[k] * square * to->e[first[mn]] * to->e[second[mn]];
    }
}

static bool laplacian_make(struct tensors *tensors, const struct correction_tensors_neighbour *neighbour,
                           size_t count, int dimension) {
    const int *first = first_of[dimension - 2], *second = second_of[dimension - 2];
    int n = packed_count(dimension), width = n + 1;
    double third[3][TENSORS_TWO], matrix[TENSORS_TWO * (TENSORS_TWO + 1)] = {0};
    third_make(third, tensors, neighbour, count, dimension);
    for (size_t j = 0; j < count; j++) {
        const struct correction_tensors_neighbour *to = &neighbour[j];
        double two[TENSORS_TWO];
        for (int op = 0; op < n; op++)
            two[op] = to->e[first[op]] * to->e[second[op]] * (first[op] == second[op] ? 1 : 2);
        for (int mn = 0; mn < n; mn++) {
            double left = to->distance * to->e[first[mn]] * to->e[second[mn]];
            for (int k = 0; k < dimension; k++)
                left += third[k][mn] * to->e[k];
            for (int op = 0; op < n; op++)
                matrix[mn * width + op] += to->strength * left * two[op];
        }
    }
    for (int mn = 0; mn < n; mn++)
        matrix[mn * width + n] = mn < dimension ? -1 : 0;
    if (!solve(matrix, n, width))
        return false;
    for (int mn = 0; mn < n; mn++)
        tensors->laplacian[mn] = matrix[mn * width + n];
    return true;
}

/* a = 2 V W' (L : e e). */
static double strength_of(const struct tensors *tensors, const struct correction_tensors_neighbour *to,
                          int dimension) {
    const int *first = first_of[dimension - 2], *second = second_of[dimension - 2];
    double sum = 0;
    for (int op = 0; op < packed_count(dimension); op++)
        sum +=
            tensors->laplacian[op] * to->e[first[op]] * to->e[second[op]] * (first[op] == second[op] ? 1 : 2);
    return 2 * to->strength * sum;
}

bool correction_tensors_make(struct tensors *tensors, const struct correction_tensors_neighbour *neighbour,
                             size_t count, int dimension) {
    *tensors = (struct tensors){0};
    if (!gradient_make(tensors, neighbour, count, dimension) ||
        !laplacian_make(tensors, neighbour, count, dimension)) {
        correction_tensors_standard(tensors, dimension);
        return false;
    }
    for (size_t j = 0; j < count; j++) {
        double a = strength_of(tensors, &neighbour[j], dimension);
        for (int d = 0; d < dimension; d++)
            tensors->rest[d] += a * neighbour[j].e[d];
    }
    return true;
}

double correction_tensors_weigh(const struct tensors *tensors,
                                const struct correction_tensors_neighbour *neighbour, int dimension,
                                double *vector) {
    double weight = -strength_of(tensors, neighbour, dimension) / neighbour->distance;
    vector_weigh(tensors, neighbour, dimension, vector);
    for (int d = 0; d < dimension; d++)
        weight -= tensors->rest[d] * vector[d];
    return weight;
}
