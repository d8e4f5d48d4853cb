/* SPDX-License-Identifier: BSD-3-Clause */
/* Choices that follow from the options of a fluid. Read fluid.h first. */
#include "physics/fluid/fluid.h"

double fluid_support(const struct fluid_options *options, int dimension) {
    static const double of_order[] = {0, 2.2, 2.6, 3.1, 3.6}; /* moving least squares */
    static const double of_lattice[][2] = {[FLUID_CUBIC] = {2.3, 2.2},
                                           [FLUID_BCC] = {2.3, 1.95},
                                           [FLUID_FCC] = {2.3, 2.1},
                                           [FLUID_HEXAGONAL] = {2.4, 2.2}};
    double support = options->kernel.support;
    bool displaced = options->fill.jitter > 0 || options->motion.name != FLUID_FIXED;
    if (!isnan(support))
        return support * options->spacing;
    support = displaced ? (dimension == 2 ? 3.1 : 2.8) : of_lattice[options->fill.arrangement][dimension - 2];
    if (options->operators.name == WEIGHTS_MLS)
        support = fmax(support, of_order[options->operators.order]);
    return support * options->spacing;
}

double fluid_slip(const struct fluid_options *options) {
    return options->walls.condition ? options->walls.slip_length : 0;
}

bool fluid_rigid(const struct fluid_options *options) {
    return options->grains.coupling == FLUID_RIGID;
}

bool fluid_carries(const struct fluid_options *options) {
    return options->motion.name == FLUID_LAGRANGIAN;
}
