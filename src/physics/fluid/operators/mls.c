/* SPDX-License-Identifier: BSD-3-Clause */
/* Fits polynomials to neighbourhoods. Read mls.h first. */
#include "physics/fluid/operators/mls.h"
#include <math.h>

/* A pivot of the moments, scaled to a diagonal of 1, below which the polynomial is not determined. */
#define SINGULAR 1e-9

/* Derivatives: a gradient, and the Laplacian. */
enum { SIDES = 4 };

/* The exponents of the monomials: constant, linear ones in the order of directions, then by degree. */
struct exponents {
    int terms;
    int of[MLS_TERMS_MAX][3];
};

/* Moments scaled to a diagonal of 1, and right-hand sides. */
struct fit {
    int terms, sides;
    double moment[MLS_TERMS_MAX][MLS_TERMS_MAX]; /* the lower triangle; then Cholesky's factor */
    double scale[MLS_TERMS_MAX];
    double side[SIDES][MLS_TERMS_MAX];
};

static struct exponents exponents_of(int order, int dimension) {
    struct exponents exponents = {0};
    for (int degree = 0; degree <= order; degree++)
        for (int x = degree; x >= 0; x--)
            for (int y = degree - x; y >= (dimension == 2 ? degree - x : 0); y--) {
                int *one = exponents.of[exponents.terms++];
                one[0] = x;
                one[1] = y;
                one[2] = degree - x - y;
            }
    return exponents;
}

int mls_terms(int order, int dimension) {
    return exponents_of(order, dimension).terms;
}

/* The monomials of a neighbour. */
static void monomials(const struct exponents *exponents, const struct mls_options *options,
                      const struct correction_tensors_neighbour *to, double *p) {
    double power[3][MLS_ORDER_MAX + 1];
    for (int d = 0; d < 3; d++) {
        double x = -to->e[d] * to->distance / options->scale;
        power[d][0] = 1;
        for (int k = 1; k <= options->order; k++)
            power[d][k] = power[d][k - 1] * x;
    }
    for (int a = 0; a < exponents->terms; a++)
        p[a] = power[0][exponents->of[a][0]] * power[1][exponents->of[a][1]] * power[2][exponents->of[a][2]];
}

static void moments_make(struct fit *fit, const struct exponents *exponents,
                         const struct mls_options *options,
                         const struct correction_tensors_neighbour *neighbour, size_t count) {
    double p[MLS_TERMS_MAX];
    fit->terms = exponents->terms;
    fit->moment[0][0] = 1; /* i itself: W(0) / W(0) */
    for (size_t j = 0; j < count; j++) {
        double share = neighbour[j].value / options->own;
        monomials(exponents, options, &neighbour[j], p);
        for (int a = 0; a < fit->terms; a++)
            for (int b = 0; b <= a; b++)
                fit->moment[a][b] += share * p[a] * p[b];
    }
}

/* The derivatives of the monomials at i: the gradient's, and from order 2 on the Laplacian's. */
static void sides_make(struct fit *fit, const struct exponents *exponents,
                       const struct mls_options *options) {
    fit->sides = options->dimension + (options->order > 1);
    for (int a = 0; a < fit->terms; a++) {
        const int *of = exponents->of[a];
        int degree = of[0] + of[1] + of[2];
        for (int d = 0; d < options->dimension; d++) {
            if (degree == 1 && of[d] == 1)
                fit->side[d][a] = 1 / options->scale;
            if (degree == 2 && of[d] == 2)
                fit->side[options->dimension][a] = 2 / (options->scale * options->scale);
        }
    }
}

/* Cholesky's factor of the scaled moments; false where a pivot is too small. */
static bool factorise(struct fit *fit) {
    for (int a = 0; a < fit->terms; a++) {
        if (!(fit->moment[a][a] > 0))
            return false;
        fit->scale[a] = 1 / sqrt(fit->moment[a][a]);
    }
    for (int a = 0; a < fit->terms; a++)
        for (int b = 0; b <= a; b++) {
            double sum = fit->moment[a][b] * fit->scale[a] * fit->scale[b];
            for (int k = 0; k < b; k++)
                sum -= fit->moment[a][k] * fit->moment[b][k];
            if (a == b && !(sum > SINGULAR))
                return false;
            fit->moment[a][b] = a == b ? sqrt(sum) : sum / fit->moment[b][b];
        }
    return true;
}

static void solve(const struct fit *fit, double *x) {
    for (int a = 0; a < fit->terms; a++) {
        x[a] *= fit->scale[a];
        for (int k = 0; k < a; k++)
            x[a] -= fit->moment[a][k] * x[k];
        x[a] /= fit->moment[a][a];
    }
    for (int a = fit->terms - 1; a >= 0; a--) {
        for (int k = a + 1; k < fit->terms; k++)
            x[a] -= fit->moment[k][a] * x[k];
        x[a] /= fit->moment[a][a];
    }
    for (int a = 0; a < fit->terms; a++)
        x[a] *= fit->scale[a];
}

bool mls_weigh(const struct mls_options *options, const struct correction_tensors_neighbour *neighbour,
               size_t count, double *vector, double *scalar) {
    const struct exponents exponents = exponents_of(options->order, options->dimension);
    struct fit fit = {0};
    double p[MLS_TERMS_MAX];
    if (count + 1 < (size_t)exponents.terms)
        return false;
    moments_make(&fit, &exponents, options, neighbour, count);
    sides_make(&fit, &exponents, options);
    if (!factorise(&fit))
        return false;
    for (int s = 0; s < fit.sides; s++)
        solve(&fit, fit.side[s]);
    for (size_t j = 0; j < count; j++) {
        double share = neighbour[j].value / options->own;
        monomials(&exponents, options, &neighbour[j], p);
        for (int s = 0; s < fit.sides; s++) {
            double sum = 0;
            for (int a = 0; a < fit.terms; a++)
                sum += fit.side[s][a] * p[a];
            *(s < options->dimension ? &vector[j * (size_t)options->dimension + (size_t)s] : &scalar[j]) =
                share * sum;
        }
    }
    return true;
}
