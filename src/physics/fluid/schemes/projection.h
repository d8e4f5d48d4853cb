/* SPDX-License-Identifier: BSD-3-Clause */
/* One step of an incompressible flow on fixed particles: incremental projection with a rotational correction
 * of the pressure (Brown, Cortez, Minion, J. Comput. Phys. 168 (2001) 464; Guermond, Minev, Shen, CMAME 195
 * (2006) 6011), Crank and Nicolson's viscosity, Adams and Bashforth's advection:
 *
 *   (1 - theta dt nu div grad) u* = u^n + dt [(1 - theta) nu div grad u^n - A - grad p / rho + f / rho]
 *   div grad phi = rho / dt (div u* - mean),   u^(n+1) = u* - dt / rho grad phi
 *   p -> p + phi - theta mu div u*
 *
 * Where grains that the fluid does not resolve take part in a step (physics/fluid/coupling/unresolved_grains.h), u* becomes u^n + (u* - u^n) / (1 + a), and the
 * last two lines are div k grad phi and dt / rho k grad phi, with a (flow->resist) and k (flow->mobility) of each particle. A(u) is that of flow->carried.
 *
 * with theta = 1/2 and A = 3/2 A(u^n) - 1/2 A(u^(n-1)), A(u) of operators_inertia, for equal steps; in the first step
 * theta = 1 (backward Euler) and A = A(u^0). Second order in dt for the velocity; p belongs to the
 * middle of the step. No limit of dt from viscosity; advection wants max |u| dt <= 0.5 spacing. Between grains and open sides
 * the Poisson equation is div c grad phi, c of gradient_correction.h: what it leaves of a divergence is gone after some steps, on a cubic lattice within ten. */
#ifndef SCREE_SCHEMES_PROJECTION_H
#define SCREE_SCHEMES_PROJECTION_H

#include "physics/fluid/schemes/flow.h"
#include "physics/solve/solve.h"

struct projection_options {
    double density, viscosity;  /* viscosity: dynamic */
    double spacing;             /* length; with dt it chooses the preconditioner of the velocity */
    double dt;                  /* the usual step: the matrices are made for it */
    bool advection;             /* false: Stokes */
    const char *preconditioner; /* of the pressure, and of the velocity where dt is long (solve.h) */
    double tolerance_velocity, tolerance_pressure; /* relative residuals */
    int reuse;                                     /* of the pressure's preconditioner, as in solve.h */
};

/* What the next step must know of the ones before; a restart keeps it, beside flow->advection_before. */
struct projection_past {
    int64_t steps;
    double dt; /* of the last step */
};

struct projection;

/* Makes matrices and solvers for a flow (flow_number has been called), which later steps must show unchanged
 * but for its values. NULL with an error. Collective, as all here. */
struct projection *projection_create(struct solve *solve, const struct flow *flow,
                                     const struct projection_options *options, struct error *error);
void projection_destroy(struct projection **projection);

/* The weights have new values on the old pattern: particles have moved. */
void projection_refill(struct projection *projection, const struct flow *flow);

/* flow->mobility has new values. */
void projection_refill_pressure(struct projection *projection, const struct flow *flow);

/* The next solve for the pressure makes its preconditioner: after a checkpoint, as a run that is resumed from it does.
 * Not collective, but alike on all ranks. */
void projection_renew(struct projection *projection);

/* Makes a step under a force per volume; copies of velocity and pressure are up to date before and after.
 * False, with an error (ERROR_PHYSICS), if a solver failed. */
bool projection_step(struct projection *projection, const struct flow *flow, struct projection_past *past,
                     double dt, const double force[3], struct error *error);

/* The course of the solvers (of one component of the velocity); the divergence of u* that the last step removed: root mean square over rows of
 * all ranks, as computed before the correction. */
struct projection_report {
    const struct solve_report *velocity, *pressure;
    double residual;   /* the largest true one of the last step's solves */
    double divergence; /* 1/time */
};
struct projection_report projection_report(const struct projection *projection);

#endif
