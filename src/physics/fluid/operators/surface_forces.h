/* SPDX-License-Identifier: BSD-3-Clause */
/* The force of the fluid on the bodies that bound it: the momentum that leaves the fluid through its wall
 * neighbours. On a lattice the exchanges between fluid particles cancel in pairs, so the forces on all bodies
 * add up to that on the fluid:
 *
 *   F_g = sum over fluid i of V_i sum over j of body g of [mu w_ij (1 + beta_ij) (u_i - u_w) + 2 p_i b_ij]
 *
 * Of a body that turns, grain or wall, u_w is its rigid motion at x_i: what the mirror adds for the turn (weights.h) has no net force on a
 * closed body, and its torque is that of the rotation of fluid in the body's place, 2 mu V omega, which mu grad u has and stress has not
 * (of a bore -2 mu V omega, V the room within).
 * With a slip length (1 + beta)(u_i - u_w) is what the mirror gives (operators_mirror), and the same part of stress, that of the fluid's
 * slip v = (u_i - u_w) b / (d_i + b) along the surface, has a torque, too, -mu the integral of n x v, and on a closed body no force:
 *
 *   C_g = sum over fluid i of V_i sum over j of body g of 2 mu b_ij x v
 *
 * p lacks the pressure
 * whose mean gradient drives the flow. */
#ifndef SCREE_OPERATORS_SURFACE_FORCES_H
#define SCREE_OPERATORS_SURFACE_FORCES_H

#include "physics/fluid/schemes/flow.h"

/* The force at one foot, in two parts. */
struct surface_forces_part {
    double viscous[3], pressure[3];
    double couple[3]; /* the torque beside that of both forces */
};

/* The forces at all feet of the weights, with the bodies that they act on. All owned. */
struct forces {
    struct surface_forces_part *part; /* by foot; NULL: none yet */
    size_t *grain; /* by foot: number of the grain, owned or a copy; SIZE_MAX: another body */
};
void surface_forces_free(struct forces *forces);

/* part[foot] = the force on the body of the foot, over the neighbours of its row; feet lie at x_i - d_i n.
 * `viscosity` is dynamic. Copies need not be up to date. Opens its own team. */
void surface_forces_feet(const struct flow *flow, double viscosity, struct surface_forces_part *part);

/* torque = that of a part whose forces act at the end of a lever. Any thread. */
void surface_forces_torque(const struct surface_forces_part *part, const double lever[3], double torque[3]);

#endif
