/* SPDX-License-Identifier: BSD-3-Clause */
/* Smoothing kernels, by their support radius R, from which on they are zero: W(r) = s f(q),
 * W'(r) = s / R f'(q), q = r / R. (R is 2 h for Wendland's kernels and 3 h for the quintic spline, in the
 * smoothing length h that other codes give.) Sources: Dehnen and Aly, MNRAS 425 (2012) 1068, table 1;
 * Morris, Fox, Zhu, J. Comput. Phys. 136 (1997) 214.
 *
 * How to add a kernel: a number of enum kernel_name, a row in kernel.c, a case in the two functions below. */
#ifndef SCREE_FLUID_KERNEL_H
#define SCREE_FLUID_KERNEL_H

enum kernel_name { KERNEL_WENDLAND_C2, KERNEL_WENDLAND_C4, KERNEL_WENDLAND_C6, KERNEL_QUINTIC, KERNELS };

/* A kernel of one support and dimension. Plain data. */
struct kernel {
    enum kernel_name name;
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

/* (a - s)_+ to the power n. */
static inline double kernel_rest(double a, double s, int n) {
    return s < a ? kernel_power(a - s, n) : 0;
}

/* W(r), r >= 0; 0 from the support on. Any thread. */
static inline double kernel_value(const struct kernel *kernel, double r) {
    double q = r / kernel->support, p = 1 - q, s = 3 * q;
    if (!(q < 1))
        return 0;
    switch (kernel->name) {
    case KERNEL_WENDLAND_C4:
        return kernel->value * kernel_power(p, 6) * (35 * q * q + 18 * q + 3) / 3;
    case KERNEL_WENDLAND_C6:
        return kernel->value * kernel_power(p, 8) * (32 * q * q * q + 25 * q * q + 8 * q + 1);
    case KERNEL_QUINTIC:
        return kernel->value *
               (kernel_power(3 - s, 5) - 6 * kernel_rest(2, s, 5) + 15 * kernel_rest(1, s, 5));
    default:
        return kernel->value * kernel_power(p, 4) * (4 * q + 1);
    }
}

/* dW/dr, not positive; 0 from the support on. Any thread. */
static inline double kernel_slope(const struct kernel *kernel, double r) {
    double q = r / kernel->support, p = 1 - q, s = 3 * q;
    if (!(q < 1))
        return 0;
    switch (kernel->name) {
    case KERNEL_WENDLAND_C4:
        return kernel->slope * -56.0 / 3 * q * (5 * q + 1) * kernel_power(p, 5);
    case KERNEL_WENDLAND_C6:
        return kernel->slope * -22 * q * (16 * q * q + 7 * q + 1) * kernel_power(p, 7);
    case KERNEL_QUINTIC:
        return kernel->slope * 3 *
               (-5 * kernel_power(3 - s, 4) + 30 * kernel_rest(2, s, 4) - 75 * kernel_rest(1, s, 4));
    default:
        return kernel->slope * -20 * q * kernel_power(p, 3);
    }
}

#endif
