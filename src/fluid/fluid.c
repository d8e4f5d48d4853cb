/* SPDX-License-Identifier: BSD-3-Clause */
/* Choices that follow from the options of a fluid. Read fluid.h first. */
#include "fluid/fluid.h"

double fluid_support(const struct fluid_options *options, int dimension) {
    double support = options->kernel.support;
    if (isnan(support) && options->fill.jitter > 0)
        support = dimension == 2 ? 3.1 : 2.8;
    else if (isnan(support))
        support = dimension == 2 ? 2.3 : 2.2;
    return support * options->spacing;
}

double fluid_slip(const struct fluid_options *options) {
    return options->walls.condition ? options->walls.slip_length : 0;
}
