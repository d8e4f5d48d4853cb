/* SPDX-License-Identifier: BSD-3-Clause */
/* Anderson's method. Read anderson.h first. */
#include "physics/fluid/schemes/anderson.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

void anderson_begin(struct anderson *anderson, const struct comm *comm, size_t count) {
    anderson->comm = comm;
    anderson->tries = 0;
    anderson->count = count;
    if (count > anderson->room) {
        anderson_free(anderson);
        *anderson = (struct anderson){.comm = comm, .count = count, .room = count + count / 8};
    }
}

static double product(const struct anderson *anderson, const double *a, const double *b) {
    double sum = 0;
    for (size_t k = 0; k < anderson->count; k++)
        sum += a[k] * b[k];
    comm_sum(anderson->comm, &sum, 1);
    return sum;
}

static void add(const struct anderson *anderson, double *a, double part, const double *b) {
    for (size_t k = 0; k < anderson->count; k++)
        a[k] += part * b[k];
}

static double *array(const struct anderson *anderson, double **at) {
    if (*at == NULL)
        *at = memory_allocate(anderson->room, sizeof **at, "grains in a fluid");
    return *at;
}

/* The differences from the try before become column n: orthogonal to those before it, of length 1. */
static void difference(struct anderson *anderson, int n, const double *x, const double *f) {
    double *dx = array(anderson, &anderson->x[n]), *df = array(anderson, &anderson->f[n]);
    for (size_t k = 0; k < anderson->count; k++) {
        dx[k] = x[k] - anderson->x_before[k];
        df[k] = f[k] - anderson->f_before[k];
    }
    for (int m = 0; m < n; m++) {
        double part = product(anderson, df, anderson->f[m]);
        add(anderson, df, -part, anderson->f[m]);
        add(anderson, dx, -part, anderson->x[m]);
    }
    double size = sqrt(product(anderson, df, df)), share = size > 0 ? 1 / size : 0;
    for (size_t k = 0; k < anderson->count; k++) {
        dx[k] *= share;
        df[k] *= share;
    }
}

void anderson_next(struct anderson *anderson, double *x, const double *f) {
    double *x_before = array(anderson, &anderson->x_before), *f_before = array(anderson, &anderson->f_before);
    double part[ANDERSON_MOST];
    int columns = anderson->tries < ANDERSON_MOST ? anderson->tries : ANDERSON_MOST;
    if (anderson->tries > 0 && anderson->tries <= ANDERSON_MOST)
        difference(anderson, anderson->tries - 1, x, f);
    for (int m = 0; m < columns; m++)
        part[m] = product(anderson, f, anderson->f[m]);
    memcpy(x_before, x, anderson->count * sizeof *x);
    memcpy(f_before, f, anderson->count * sizeof *f);
    add(anderson, x, 1, f);
    for (int m = 0; m < columns; m++) {
        add(anderson, x, -part[m], anderson->x[m]);
        add(anderson, x, -part[m], anderson->f[m]);
    }
    anderson->tries++;
}

void anderson_free(struct anderson *anderson) {
    memory_free(anderson->x_before);
    memory_free(anderson->f_before);
    for (int m = 0; m < ANDERSON_MOST; m++) {
        memory_free(anderson->x[m]);
        memory_free(anderson->f[m]);
    }
    *anderson = (struct anderson){0};
}
