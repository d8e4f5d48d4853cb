/* SPDX-License-Identifier: BSD-3-Clause */
/* Shifting: particles that follow the flow gather along some directions and leave gaps in others; a small velocity
 * against the gradient of their concentration keeps them apart (Lind, Xu, Stansby, Rogers, J. Comput. Phys. 231 (2012)
 * 1499, with the pairing term of Monaghan 2000):
 *
 *   s_i = -A dx U grad C_i,   grad C_i = sum V_j W'_ij (1 + 0.2 (W_ij / W(dx))^4) e_ij,   |s| <= most
 *
 * U is the largest speed of the fluid. Boundary particles count. Fields follow by the advection with s (moving_step.h).
 *
 * Particles are kept off surfaces, too: the velocity that a projection leaves beside a surface lets particles come nearer
 * and nearer to it, and go behind it. There 1 + beta, by which forces on the body weigh the velocity against that of the
 * surface, goes up to 10^4 and more, and the forces lose their sense, though the flow keeps it. */
#ifndef SCREE_SCHEMES_PARTICLE_SHIFT_H
#define SCREE_SCHEMES_PARTICLE_SHIFT_H

#include "physics/fluid/schemes/flow.h"

struct particle_shift_options {
    double strength; /* A */
    double speed;    /* U, length/time */
    double most;     /* length/time */
};

/* drift[3 * particle] = s of the owned fluid particles, from rows that weights_make has made for the same input and
 * options. Opens its own team. */
void particle_shift_velocity(const struct weights *weights, const struct weights_input *input,
                             const struct weights_options *options,
                             const struct particle_shift_options *shift, double *drift);

/* Least distance from a surface, in spacings: particles nearer to it are sent away from it. */
#define SHIFT_LEAST 0.25

struct particle_shift_off {
    double least; /* length */
    double most;  /* length/time: of particles that are nearer, away from the surface */
    double dt;    /* of the next step */
    double ahead; /* as of moving_step_velocity */
};

/* Adds to the drift of the owned fluid particles what keeps them off the surfaces of bodies: none comes nearer than
 * off->least in the next step, and one that is nearer goes away from the surface. Opens its own team. */
void particle_shift_keep_off(const struct flow *flow, const struct particle_shift_off *off);

#endif
