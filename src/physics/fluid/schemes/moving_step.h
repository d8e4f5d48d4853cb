/* SPDX-License-Identifier: BSD-3-Clause */
/* One step of an incompressible flow on particles that move with velocity w = u + s, u that of the fluid, s the drift:
 * that of shifting (particle_shift.h), or of points whose motion is given. All operators stand at the new places. Backward
 * differences of second order along the paths, after the incremental projection of projection.h:
 *
 *   (1 - g dt nu div grad) u* = a u^n - b u^(n-1) + g dt [(1 + r) c^n - r c^(n-1) - grad p^n / rho + f / rho]
 *   div grad phi = rho / (g dt) (div u* - mean + tau / rho (div grad p - lap p)),   u^(n+1) = u* - g dt / rho grad phi
 *   p -> p + phi - mu div u*,   c = (s . grad) u
 *
 * with r = dt / dt of the step before, g = (1 + r) / (1 + 2 r), a = (1 + r)^2 / (1 + 2 r), b = r^2 / (1 + 2 r): 2/3,
 * 4/3, 1/3 for equal steps; r = 0, backward Euler, in the first step. c corrects the velocity, by its gradient, for the
 * drift; the pressure needs no such term, as it is a first guess, of which phi makes up what is missing. div grad p is
 * the divergence of the gradient, lap p the Laplacian; their difference is the filter of Rhie and Chow (AIAA J. 21
 * (1983) 1525) against pressures that alternate between neighbours, which the divergence of a gradient on displaced
 * particles does not see. Rows with wall neighbours have no filter: their gradient stands for half of a neighbourhood, the
 * difference is no small one, and fast grains were swung up by it. Crank and Nicolson's rule is only of first order here, as the gradient of the pressure belongs
 * to the end of the path. */
#ifndef SCREE_SCHEMES_MOVING_STEP_H
#define SCREE_SCHEMES_MOVING_STEP_H

#include "physics/fluid/schemes/projection.h"

/* A step that has begun: how far it goes, and the factor g of its implicit part. Borrows all. */
struct path {
    struct projection *projection;
    const struct flow *flow;
    double dt, implicit;
};

/* What pushes the fluid in a step: a force per volume; tau / dt of the filter. */
struct moving_step_push {
    const double *force;
    double filter;
};

/* Begins a step at the new places, to which projection_create or projection_refill has brought the matrices: all that does not
 * depend on the velocities of the walls. flow->velocity_before becomes u^n; drift and its advection are still those of the step
 * before. Collective. */
struct path moving_step_begin(struct projection *projection, const struct flow *flow,
                              const struct projection_past *past, double dt,
                              const struct moving_step_push *push);

/* Makes the step with the present velocities of the feet: velocity and pressure, of copies too, become those at its end. May be
 * called again, with other velocities. False with an error (ERROR_PHYSICS) if a solver failed. Collective. */
bool moving_step_try(const struct path *path, struct error *error);

/* u + (r/2) (u - u of the step before) + s: the velocity of a particle from this step to the next, by particle
 * number; `ahead` = r/2, 0 before the first step. */
static inline void moving_step_velocity(const struct flow *flow, size_t particle, double ahead, double w[3]) {
    const double *u = flow->velocity + particle * flow->velocity_stride;
    for (size_t d = 0; d < 3; d++)
        w[d] =
            u[d] + ahead * (u[d] - flow->velocity_before[3 * particle + d]) + flow->drift[3 * particle + d];
}

/* The advection by the drift becomes that of the step before, and is made for the present drift. The mirror is capped: a
 * particle that has come up to a wall, and is sent away, would get 1 + beta times the velocity of the wall. */
void moving_step_drift_advect(const struct flow *flow);

#endif
