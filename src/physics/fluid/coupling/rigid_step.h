/* SPDX-License-Identifier: BSD-3-Clause */
/* A step of a fluid that fills the whole box, grains included (solid_field.h), on a lattice at rest: inside of grains the flow is rigid. Forcing and pressure
 * are found together; projection.h has the scheme without them:
 *
 *   (1 - theta dt nu div grad) u* = u^n + dt [(1 - theta) nu div grad u^n - A - grad p / rho + f / rho] + q^n,   w = u* - q^n
 *   q = sum over grains of g_i (U_i + omega_i x r - v),   v = u - q,   U_i, omega_i of rigid_grains.h from v
 *   div grad phi = rho / dt div (w + q),   u = w + q - dt / rho grad phi,   p -> p + phi - theta mu div (w + q)
 *
 * q^n, the forcing of the step before, stands under the viscous operator and is taken off again: else the forcing leaks by sqrt(nu dt). The last two lines are a fixed point of q, found by
 * Anderson's method (anderson.h) with a Poisson solve an iteration; it ends when q lacks RIGID_TOLERANCE of the largest speed (rms over the nodes of grains), and the fluid gets what q lacks still, so that
 * grains and fluid keep their momentum to rounding. No matrix depends on the grains. A gap between grains has no added mass without bound, as the fluid inside of grains carries it. */
#ifndef SCREE_COUPLING_RIGID_STEP_H
#define SCREE_COUPLING_RIGID_STEP_H

#include "engine/physics.h"
#include "physics/fluid/coupling/rigid_sums.h"

#define RIGID_TOLERANCE 1e-3
enum { RIGID_ITERATIONS = 12 };

/* After a rebuild: takes the pairs of nodes and grains; the first time also finds the walls that move through the fluid. `pairs` are the rows of all pairs. */
void rigid_step_pairs(const struct physics_context *context, struct rigid *rigid,
                      const struct pair_rows *pairs);

/* Makes the step: flow, motions (rigid_fields_motion) and loads of the grains. False, with an error (ERROR_PHYSICS), if a solver failed. Collective. */
bool rigid_step(const struct physics_context *context, struct error *error);

/* Before output: fills the field `solid` at the present places, and the field `drag` of grains. The load of a grain has, beside the drag, V f, f the force that drives the fluid. */
void rigid_step_look(const struct physics_context *context);

void rigid_step_free(struct rigid *rigid);

#endif
