/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of kernels. Read kernel.h first. */
#include "physics/fluid/operators/kernel.h"
#include <math.h>

/* (3 - s)^5 - 6 (2 - s)^5 + 15 (1 - s)^5, s = 3 q, is 3^5 times the terms of `quintic`. */
static const struct kernel_row rows[KERNELS] = {
    [KERNEL_WENDLAND_C2] = {"wendland_c2", 7 / M_PI, 21 / (2 * M_PI), 1, {{1, 4, {1, 4}}}},
    [KERNEL_WENDLAND_C4] = {"wendland_c4", 9 / M_PI, 495 / (32 * M_PI), 1, {{1, 6, {1, 6, 35.0 / 3}}}},
    [KERNEL_WENDLAND_C6] = {"wendland_c6", 78 / (7 * M_PI), 1365 / (64 * M_PI), 1, {{1, 8, {1, 8, 25, 32}}}},
    [KERNEL_QUINTIC] = {"quintic",
                        63 / (478 * M_PI),
                        27 / (120 * M_PI),
                        3,
                        {{1, 5, {243}}, {2.0 / 3, 5, {-6 * 243}}, {1.0 / 3, 5, {15 * 243}}}}};

const char *kernel_name(enum kernel_name name) {
    return rows[name].name;
}

struct kernel kernel_make(enum kernel_name name, double support, int dimension) {
    struct kernel kernel = {.row = &rows[name], .support = support};
    kernel.value =
        dimension == 2 ? rows[name].two / (support * support) : rows[name].three / kernel_power(support, 3);
    kernel.slope = kernel.value / support;
    return kernel;
}
