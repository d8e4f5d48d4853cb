/* SPDX-License-Identifier: BSD-3-Clause */
/* What output shows of a flow beside velocity and pressure. Copies of the velocity must be up to date. */
#ifndef SCREE_FLUID_FLOW_OUTPUT_H
#define SCREE_FLUID_FLOW_OUTPUT_H

#include "physics/fluid/schemes/flow.h"

/* Fills flow->predicted, which is free between steps, with the vorticity, curl u, of the owned fluid
 * particles. */
void flow_vorticity(const struct flow *flow);

/* Fills `force` (3 components by particle number) of the owned fluid particles with share x div grad u: with
 * share = viscosity x spacing^dimension the force of viscosity on a cell of the lattice. */
void flow_viscous(const struct flow *flow, double share, double *force);

#endif
