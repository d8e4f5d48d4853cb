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

/* What pushes the fluid in a step. */
struct projection_push {
    double dt;
    const double *force;        /* force/volume, everywhere */
    const double (*impulse)[3]; /* by row: change of velocity beside it; NULL: none */
};

/* The part of the viscosity that the end of the step has. */
static inline double projection_theta(const struct projection_past *past) {
    return past->steps > 0 ? 0.5 : 1;
}

/* The momentum equation: u* in flow->predicted. False, with an error, if a solver failed. Collective. */
bool projection_predict(struct projection *projection, const struct flow *flow,
                        const struct projection_past *past, const struct projection_push *push,
                        struct error *error);

/* The Poisson equation: phi, in flow->increment, of the present flow->predicted; `guess`: its present values are a first guess. Collective. */
bool projection_project(struct projection *projection, const struct flow *flow, double dt, bool guess,
                        struct error *error);

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
