/* SPDX-License-Identifier: BSD-3-Clause */
/* The state of a fluid between its passes: `self` of fluid_physics. */
#ifndef SCREE_FLUID_STATE_H
#define SCREE_FLUID_STATE_H

#include "fluid/fluid.h"

struct flow;

struct fluid {
    const struct fluid_options *options; /* borrowed */
    double support;                      /* radius, length */
    double volume;                       /* of a particle on the lattice, length^dimension; 0: they differ */
    struct pair_rows pairs;              /* of all owned particles; empty again once weights are made */
    struct weights weights;
    double rows[2]; /* of all ranks: fluid particles, those with singular tensors */
    size_t lost;    /* wall neighbours without a body */
};

#endif
