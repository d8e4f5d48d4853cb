/* SPDX-License-Identifier: BSD-3-Clause */
/* Shifting: particles that follow the flow gather along some directions and leave gaps in others; a small velocity
 * against the gradient of their concentration keeps them apart (Lind, Xu, Stansby, Rogers, J. Comput. Phys. 231 (2012)
 * 1499, with the pairing term of Monaghan 2000):
 *
 *   s_i = -A dx U grad C_i,   grad C_i = sum V_j W'_ij (1 + 0.2 (W_ij / W(dx))^4) e_ij,   |s| <= most
 *
 * U is the largest speed of the fluid. Boundary particles count. Fields follow by the advection with s (path.h). */
#ifndef SCREE_FLUID_SHIFT_H
#define SCREE_FLUID_SHIFT_H

#include "fluid/weights.h"

struct shift_options {
    double strength; /* A */
    double speed;    /* U, length/time */
    double most;     /* length/time */
};

/* drift[3 * particle] = s of the owned fluid particles, from rows that weights_make has made for the same input and
 * options. Opens its own team. */
void shift_velocity(const struct weights *weights, const struct weights_input *input,
                    const struct weights_options *options, const struct shift_options *shift, double *drift);

#endif
