/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of kernels: names and normalisations in two and three dimensions. Read kernel.h first. */
#include "fluid/kernel.h"
#include <math.h>

/* Integral of W over the space is 1 with value = two / R^2 or three / R^3. */
static const struct {
    const char *name;
    double two, three;
} rows[KERNELS] = {[KERNEL_WENDLAND_C2] = {"wendland_c2", 7 / M_PI, 21 / (2 * M_PI)},
                   [KERNEL_WENDLAND_C4] = {"wendland_c4", 9 / M_PI, 495 / (32 * M_PI)},
                   [KERNEL_WENDLAND_C6] = {"wendland_c6", 78 / (7 * M_PI), 1365 / (64 * M_PI)},
                   [KERNEL_QUINTIC] = {"quintic", 63 / (478 * M_PI), 27 / (120 * M_PI)}};

const char *kernel_name(enum kernel_name name) {
    return rows[name].name;
}

struct kernel kernel_make(enum kernel_name name, double support, int dimension) {
    struct kernel kernel = {.name = name, .support = support};
    kernel.value =
        dimension == 2 ? rows[name].two / (support * support) : rows[name].three / kernel_power(support, 3);
    kernel.slope = kernel.value / support;
    return kernel;
}
