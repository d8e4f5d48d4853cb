/* SPDX-License-Identifier: BSD-3-Clause */
/* Six equations a grain. Read rigid_grains.h first. */
#include "physics/fluid/coupling/rigid_grains.h"
#include <math.h>

void rigid_grains_add(struct rigid_grains_sums *sums, double mass, const double arm[3]) {
    double x = arm[0], y = arm[1], z = arm[2];
    sums->mass += mass;
    for (int d = 0; d < 3; d++)
        sums->first[d] += mass * arm[d];
    sums->second[0] += mass * (y * y + z * z);
    sums->second[1] += mass * (x * x + z * z);
    sums->second[2] += mass * (x * x + y * y);
    sums->second[3] -= mass * y * z;
    sums->second[4] -= mass * x * z;
    sums->second[5] -= mass * x * y;
}

/* Where a symmetric tensor has its entries. */
static const int at[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

void rigid_grains_spin(const double inertia[6], const double omega[3], double spin[3]) {
    for (int i = 0; i < 3; i++) {
        spin[i] = 0;
        for (int j = 0; j < 3; j++)
            spin[i] += inertia[at[i][j]] * omega[j];
    }
}

/* The matrix of all six unknowns; it is symmetric. */
static void fill(const struct rigid_grains_sums *sums, const struct rigid_grains_own *own, double a[6][6]) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            a[i][j] = i == j ? sums->mass + own->mass : 0;
            a[3 + i][3 + j] = sums->second[at[i][j]] + own->inertia[at[i][j]];
            a[3 + i][j] = 0;
        }
    for (int i = 0; i < 3; i++) { /* s x U */
        int next = (i + 1) % 3, last = (i + 2) % 3;
        a[3 + i][last] = sums->first[next];
        a[3 + i][next] = -sums->first[last];
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            a[j][3 + i] = a[3 + i][j];
}

void rigid_grains_momentum(const struct rigid_grains_sums *sums, const double motion[6], double momentum[6]) {
    const struct rigid_grains_own none = {0};
    double a[6][6];
    fill(sums, &none, a);
    for (int i = 0; i < 6; i++) {
        momentum[i] = 0;
        for (int j = 0; j < 6; j++)
            momentum[i] += a[i][j] * motion[j];
    }
}

/* Gauss's elimination, with pivots, of `count` equations; b becomes the solution. */
static void eliminate(int count, double a[6][6], double b[6]) {
    for (int k = 0; k < count; k++) {
        int best = k;
        for (int i = k + 1; i < count; i++)
            best = fabs(a[i][k]) > fabs(a[best][k]) ? i : best;
        for (int j = 0; j < count; j++) {
            double keep = a[k][j];
            a[k][j] = a[best][j];
            a[best][j] = keep;
        }
        double keep = b[k];
        b[k] = b[best];
        b[best] = keep;
        for (int i = k + 1; i < count; i++) {
            double part = a[k][k] != 0 ? a[i][k] / a[k][k] : 0;
            for (int j = k; j < count; j++)
                a[i][j] -= part * a[k][j];
            b[i] -= part * b[k];
        }
    }
    for (int k = count - 1; k >= 0; k--) {
        for (int j = k + 1; j < count; j++)
            b[k] -= a[k][j] * b[j];
        b[k] = a[k][k] != 0 ? b[k] / a[k][k] : 0;
    }
}

void rigid_grains_solve(const struct rigid_grains_sums *sums, const struct rigid_grains_own *own,
                        const double momentum[6], double motion[6]) {
    double all[6][6], a[6][6], b[6];
    int unknown[6], count = 0;
    fill(sums, own, all);
    for (int d = 0; d < 6; d++) {
        bool flat = own->dimension == 2 && (d >= 2 && d <= 4);
        motion[d] = 0;
        if (!flat && (d < 3 || own->turns))
            unknown[count++] = d;
    }
    for (int i = 0; i < count; i++) {
        b[i] = momentum[unknown[i]];
        for (int j = 0; j < count; j++)
            a[i][j] = all[unknown[i]][unknown[j]];
    }
    eliminate(count, a, b);
    for (int i = 0; i < count; i++)
        motion[unknown[i]] = b[i];
}
