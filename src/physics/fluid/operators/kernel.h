/* SPDX-License-Identifier: BSD-3-Clause */
/* Smoothing kernels, by their support radius R, from which on they are zero: W(r) = s f(q),
 * W'(r) = s / R f'(q), q = r / R. (R is 2 h for Wendland's kernels and 3 h for the quintic spline, in the
 * smoothing length h that other codes give.) Sources: Dehnen and Aly, MNRAS 425 (2012) 1068, table 1;
 * Morris, Fox, Zhu, J. Comput. Phys. 136 (1997) 214.
 *
 * A kernel is a row of a table: f is a sum of terms (edge - q)_+^power (c0 + c1 q + ...), and f' follows from the
 * same numbers.
 *
 * How to add a kernel: a number of enum kernel_name, a row in kernel.c, its name in fluid_rows.c.
 * tests/physics/fluid/operators/test_fluid_operators checks the integrals of each row. */
#ifndef SCREE_OPERATORS_KERNEL_H
#define SCREE_OPERATORS_KERNEL_H

enum kernel_name { KERNEL_WENDLAND_C2, KERNEL_WENDLAND_C4, KERNEL_WENDLAND_C6, KERNEL_QUINTIC, KERNELS };

enum { KERNEL_TERMS_MAX = 3, KERNEL_FACTORS_MAX = 4 };

/* (edge - q)_+^power (factor[0] + factor[1] q + ...); power >= 1. */
struct kernel_term {
    double edge;
    int power;
    double factor[KERNEL_FACTORS_MAX];
};

/* A row: the integral of W over the space is 1 with s = two / R^2 or three / R^3. */
struct kernel_row {
    const char *name; /* in a scene: "wendland_c2" */
    double two, three;
    int terms;
    struct kernel_term term[KERNEL_TERMS_MAX];
};

/* A kernel of one support and dimension. Plain data; the row is static. */
struct kernel {
    const struct kernel_row *row;
    double support; /* R, length */
    double value;   /* factor of f, 1 / length^dimension */
    double slope;   /* factor of f', 1 / length^(dimension + 1) */
};

/* The name in a scene: "wendland_c2". */
const char *kernel_name(enum kernel_name name);

/* The kernel for a support (> 0) and a dimension, 2 or 3. */
struct kernel kernel_make(enum kernel_name name, double support, int dimension);

static inline double kernel_power(double x, int n) {
    double result = 1;
    for (; n > 0; n--)
        result *= x;
    return result;
}

/* W(r) and dW/dr, r >= 0; both 0 from the support on. Any thread. */
static inline void kernel_both(const struct kernel *kernel, double r, double *value, double *slope) {
    double q = r / kernel->support;
    *value = *slope = 0;
    for (int t = 0; t < kernel->row->terms; t++) {
        const struct kernel_term *term = &kernel->row->term[t];
        double rest = term->edge - q, sum = 0, change = 0;
        if (!(rest > 0))
            continue;
        for (int k = KERNEL_FACTORS_MAX - 1; k >= 0; k--) {
            change = change * q + sum;
            sum = sum * q + term->factor[k];
        }
        double power = kernel_power(rest, term->power - 1);
        *value += kernel->value * power * rest * sum;
        *slope += kernel->slope * power * (rest * change - term->power * sum);
    }
}

/* W(r); 0 from the support on. Any thread. */
static inline double kernel_value(const struct kernel *kernel, double r) {
    double value, slope;
    kernel_both(kernel, r, &value, &slope);
    return value;
}

/* dW/dr, not positive; 0 from the support on. Any thread. */
static inline double kernel_slope(const struct kernel *kernel, double r) {
    double value, slope;
    kernel_both(kernel, r, &value, &slope);
    return slope;
}

#endif
