/* SPDX-License-Identifier: BSD-3-Clause */
/* What the steps on particles at rest (projection.c) and on moving ones (moving_step.c) share. */
#ifndef SCREE_SCHEMES_PROJECTION_PARTS_H
#define SCREE_SCHEMES_PROJECTION_PARTS_H

#include "physics/fluid/schemes/momentum.h"
#include "physics/fluid/schemes/pressure.h"
#include "physics/fluid/schemes/projection.h"

struct projection {
    struct projection_options options;
    struct assembly assembly;
    struct momentum momentum;
    struct pressure pressure;
    /* by row */
    double (*side)[3], (*viscous)[3], (*gradient)[3], (*advection)[3];
    double *divergence, *source; /* div u*; the right-hand side that the pressure gets */
    double *filter;  /* what is added to div u* against pressures that alternate (moving_step.h) */
    double *pressed; /* p^n */
    double divergence_size;
};

/* Fills projection->divergence with div u*, and its size. Collective. */
void projection_diverge(struct projection *projection, const struct flow *flow);

/* Keeps what a step begins with: p^n, and u^n in flow->velocity_before, if there. */
void projection_keep(struct projection *projection, const struct flow *flow);

/* The velocity becomes u^n, of particles that move: the first guess of another try. */
void projection_restore(const struct flow *flow);

/* u^(n+1) = u* - share grad phi; p^(n+1) = p^n + phi - rotational div u*. Collective. */
void projection_correct(struct projection *projection, const struct flow *flow, double rotational,
                        double share);

#endif
