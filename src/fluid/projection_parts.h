/* SPDX-License-Identifier: BSD-3-Clause */
/* What the steps on particles at rest (projection.c) and on moving ones (path.c) share. */
#ifndef SCREE_FLUID_PROJECTION_PARTS_H
#define SCREE_FLUID_PROJECTION_PARTS_H

#include "fluid/momentum.h"
#include "fluid/pressure.h"
#include "fluid/projection.h"

struct projection {
    struct projection_options options;
    struct assembly assembly;
    struct momentum momentum;
    struct pressure pressure;
    /* by row */
    double (*side)[3], (*viscous)[3], (*gradient)[3], (*advection)[3];
    double *divergence, *source; /* div u*; the right-hand side that the pressure gets */
    double divergence_size;
};

/* Fills projection->divergence with div u*, and its size. Collective. */
void projection_diverge(struct projection *projection, const struct flow *flow);

/* u^(n+1) = u* - share grad phi; p -> p + phi - rotational div u*; flow->velocity_before gets u^n, if there. Collective. */
void projection_correct(struct projection *projection, const struct flow *flow, double rotational,
                        double share);

#endif
