/* SPDX-License-Identifier: BSD-3-Clause */
/* Matrices of lattices. Read lattice_matrix.h first. */
#include "lattice_matrix.h"
#include "base/memory.h"
#include <math.h>

double lattice_matrix_draw(int32_t a, int32_t b) {
    uint64_t low = (uint64_t)(a < b ? a : b), high = (uint64_t)(a < b ? b : a);
    uint64_t h = (low * 0x9E3779B97F4A7C15u) ^ (high * 0xC2B2AE3D27D4EB4Fu);
    h = (h ^ (h >> 29)) * 0xBF58476D1CE4E5B9u;
    return (double)((h ^ (h >> 32)) >> 11) * 0x1p-53;
}

static int32_t neighbour(const struct lattice_matrix *lattice, int32_t row, int direction) {
    int32_t stride = 1, side = lattice->side;
    for (int d = 0; d < direction / 2; d++)
        stride *= side;
    int32_t c = row / stride % side, to = (c + (direction % 2 ? 1 : side - 1)) % side;
    if (lattice->halves && direction < 2 && (2 * c < side) != (2 * to < side))
        return -1;
    return row + (to - c) * stride;
}

static void fill_row(struct lattice_matrix *lattice, int32_t row, int32_t *used) {
    int32_t column[LATTICE_LINKS_MAX + 1], n = 0;
    double diagonal = lattice->shift;
    for (int k = 0; k < 2 * lattice->dimension; k++) {
        int32_t other = neighbour(lattice, row, k);
        if (other >= 0)
            column[n++] = other;
    }
    column[n++] = row;
    for (int a = 1; a < n; a++)
        for (int b = a; b > 0 && column[b] < column[b - 1]; b--) {
            int32_t swap = column[b];
            column[b] = column[b - 1];
            column[b - 1] = swap;
        }
    int32_t own = -1;
    for (int k = 0; k < n; k++) {
        double weight = 1 + lattice->spread * lattice_matrix_draw(row, column[k]);
        lattice->column[*used + k] = column[k];
        lattice->value[*used + k] = -weight;
        if (column[k] == row)
            own = *used + k;
        else
            diagonal += weight;
    }
    lattice->value[own] = diagonal;
    *used += n;
}

void lattice_matrix_make(struct lattice_matrix *lattice, const struct comm *comm) {
    lattice->all = lattice->side * lattice->side * (lattice->dimension == 3 ? lattice->side : 1);
    lattice->count = lattice->all / comm->size;
    lattice->first = lattice->count * comm->rank;
    size_t n = (size_t)lattice->count;
    lattice->start = memory_allocate(n + 1, sizeof(int32_t), "lattice");
    lattice->column = memory_allocate(n * (LATTICE_LINKS_MAX + 1), sizeof(int32_t), "lattice");
    lattice->value = memory_allocate(n * (LATTICE_LINKS_MAX + 1), sizeof(double), "lattice");
    lattice->region = memory_allocate(n, sizeof(int32_t), "lattice");
    int32_t used = 0;
    for (int32_t i = 0; i < lattice->count; i++) {
        int32_t row = lattice->first + i;
        lattice->start[i] = used;
        lattice->region[i] = lattice->halves && 2 * (row % lattice->side) >= lattice->side;
        fill_row(lattice, row, &used);
    }
    lattice->start[lattice->count] = used;
}

void lattice_matrix_free(struct lattice_matrix *lattice) {
    memory_free(lattice->start);
    memory_free(lattice->column);
    memory_free(lattice->value);
    memory_free(lattice->region);
}

struct solve_rows lattice_matrix_rows(const struct lattice_matrix *lattice) {
    return (struct solve_rows){lattice->count, lattice->start, lattice->column, lattice->value};
}

double lattice_matrix_residual(const struct lattice_matrix *lattice, const struct comm *comm, const double *b,
                               const double *x) {
    double *all = memory_allocate((size_t)lattice->all, sizeof(double), "lattice"), sum[2] = {0, 0};
    comm_gather_all(comm, x, (size_t)lattice->count * sizeof(double), all);
    for (int32_t i = 0; i < lattice->count; i++) {
        double r = b[i];
        for (int32_t k = lattice->start[i]; k < lattice->start[i + 1]; k++)
            r -= lattice->value[k] * all[lattice->column[k]];
        sum[0] += r * r;
        sum[1] += b[i] * b[i];
    }
    comm_sum(comm, sum, 2);
    memory_free(all);
    return sqrt(sum[0] / sum[1]);
}

double lattice_matrix_mean(const struct lattice_matrix *lattice, const struct comm *comm, const double *x) {
    double sum[2] = {0, 0};
    for (int32_t i = 0; i < lattice->count; i++)
        sum[lattice->region[i]] += x[i] / lattice->all;
    comm_sum(comm, sum, 2);
    return fmax(fabs(sum[0]), fabs(sum[1]));
}

void lattice_matrix_sides(const struct lattice_matrix *lattice, double *b, double *x) {
    for (int32_t i = 0; i < lattice->count; i++) {
        b[i] = lattice_matrix_draw(lattice->first + i, -7) + lattice->region[i];
        x[i] = 0;
    }
}

struct solve *lattice_matrix_begin(struct team *team, const char *options) {
    struct error error = {0};
    if (!solve_available())
        team_skip(team, "PETSc is not there");
    struct solve *solve = solve_begin(&team->comm, options, &error);
    team_expect(team, solve != NULL, "%s", error.text);
    return solve;
}
