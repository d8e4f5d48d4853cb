/* SPDX-License-Identifier: BSD-3-Clause */
/* What the gradient of a pressure, and the divergence of a flow, lack beside walls and grains, for flows between open sides: steady ones, and
 * in time those between grains or within meshes, and those that unresolved grains share.
 *
 * A pressure goes on evenly behind a body, so that a particle beside it sees of a linear pressure the part
 *
 *   N = sum over fluid neighbours and open sides of b_ij (x) (x_j - x_i)
 *
 * alone, in dense packings two thirds or three quarters. The mean gradient of a periodic flow is a force, and whole; between open sides it is one of the pressure.
 * There the gradient is C sum b_ij (p_j - p_i), C = 1 / N, and the divergence its adjoint, sum b_ij . (C_i u_i + C_j u_j): a linear pressure pushes as
 * the force would, what i loses j gains, bodies let nothing through, and the flow through a section is the sum of the velocities of its particles.
 * A projection in time has div c grad as its Poisson equation, with c_ij the mean of |C_i e| and |C_j e|, e along b_ij (weights_whole_along): on a lattice,
 * where b = w r / 2, the divergence of the gradient is at most s div c grad (both negative), s the largest eigenvalue of sum w r^2 / 2 (C e) (C e) / |C e|
 * over the fluid neighbours of a particle. s is 1 where C is a number or the neighbours lie along its axes, and 1.4 with eigenvalues of 5 and 1 and all
 * neighbours between both axes; a projection is stable below 2 (an incremental one
 * below 4/3 without viscosity: the growth a step is the root of x^2 - 2 (1 - s) x + 1 - s of largest size), and without c it is not. s is a bound of one row: growth of a flow with
 * c has not been seen, and that no flow grows is not proven.
 * Eigenvalues of N below WHOLE_LEAST, in pores that hold one particle, count as that. */
#ifndef SCREE_OPERATORS_GRADIENT_CORRECTION_H
#define SCREE_OPERATORS_GRADIENT_CORRECTION_H

#include "physics/fluid/operators/weights.h"

#define WHOLE_LEAST 0.2

/* Puts C of this rank's rows into whole[particle number], row after row. After mirror_make. Opens its own team. */
void gradient_correction_make(const struct weights *weights, const struct weights_input *rows,
                              double (*whole)[9]);

#endif
