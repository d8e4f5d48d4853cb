/* SPDX-License-Identifier: BSD-3-Clause */
/* Steady Stokes flow on fixed particles, velocity and pressure at once:
 *
 *   - mu div grad u + grad p = f,   - div u = 0
 *
 * by LGMRES (Baker, Jessup, Manteuffel, SIAM J. Matrix Anal. Appl. 26 (2005) 962), preconditioned from the left
 * by z_p = - mu (r_p - mean), z_u = M (r_u - grad z_p), where M is one
 * cycle of multigrid for - mu div grad, component by component: the Schur complement of Stokes is - 1 / mu times
 * something spectrally like one. One matrix, one set-up, and iterations that depend neither on viscosity nor
 * much on size. Inside, lengths are in spacings and the viscosity is 1, so that the norm that LGMRES makes
 * smallest does not depend on units.
 *
 * Collocated pressures have nearly invisible modes in dead corners, so the residual stalls long after the flow
 * has converged. Hence the solve ends when the mean flow changes by less than the tolerance over a cycle of LGMRES
 * (16 iterations) and the momentum's residual is below a thousandth of the force. In rolls without a mean flow the root mean
 * square of the velocity takes its place. Between open sides of given pressure, where the pressure
 * along the whole way is an unknown, schur.h has a better Schur complement, and at most a hundredth of the flow may get lost, too. A part of a cycle would not do: the first iterations after a restart change the
 * flow little even where it has a percent to go. Cycles of LGMRES take along the corrections of the last two cycles, and
 * so need fewer vectors than those of GMRES: 28 with 4 doubles a particle, not 36. */
#ifndef SCREE_SCHEMES_STEADY_H
#define SCREE_SCHEMES_STEADY_H

#include "physics/fluid/schemes/flow.h"
#include "physics/solve/solve.h"

struct steady_options {
    double viscosity, spacing;  /* dynamic viscosity */
    double edge;                /* the longest of the box: the way between open sides */
    double tolerance;           /* of the mean flow over a cycle */
    int iterations;             /* at most */
    const char *preconditioner; /* of the velocity (solve.h) */
};

struct steady_report {
    int iterations;
    bool converged;
    double change;     /* of the mean flow over the last cycle, relative */
    double residual;   /* of the momentum, relative to the force */
    double divergence; /* root mean square of div u, as part of the mean speed over the spacing */
    double seconds_set_up, seconds_solve;
};

struct steady;

/* Makes matrix and solver for a flow (flow_number has been called), whose weights must stay. NULL with an error:
 * a user's one if nothing holds the fluid. Collective, as all here. */
struct steady *steady_create(struct solve *solve, const struct flow *flow,
                             const struct steady_options *options, struct error *error);
void steady_destroy(struct steady **steady);

/* Solves for velocity and pressure under a force per volume, starting from those of the flow; copies are up to
 * date afterwards, and the mean pressure of each region is 0. False, with an error (ERROR_PHYSICS), if the flow
 * did not converge. */
bool steady_solve(struct steady *steady, const struct flow *flow, const double force[3],
                  struct steady_report *report, struct error *error);

#endif
