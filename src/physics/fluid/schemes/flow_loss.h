/* SPDX-License-Identifier: BSD-3-Clause */
/* The water that a flow between open sides loses on its way. With no flux through bodies, of an incompressible flow
 *
 *   sum of outflows = 0,     integral of u_d = sum over open sides of outflow x x_d     (u . grad x_d = div (x_d u))
 *
 * hold at any time: what comes in goes out, and each section between has the same flow. What is missing, as a part of the inflow, the second
 * over the edge of the box, is the loss. It is measured by the velocities of particles, not by the divergence of the scheme, which is 0 up to the
 * solver's tolerance even where operators beside bodies miss a fifth of a flow. */
#ifndef SCREE_SCHEMES_FLOW_LOSS_H
#define SCREE_SCHEMES_FLOW_LOSS_H

#include "engine/physics.h"

/* The larger part of the inflow (and of what noise of the solver a fluid at rest has) that is missing, of the outflow and of the mean flow in directions that are not periodic; 0 without inflow.
 * Collective. */
double flow_loss_measure(const struct physics_context *context);

/* After a step in time: warns, once a run, of a loss above LOSS_MOST in LOSS_STEPS steps one after another. Collective. */
#define LOSS_MOST 0.03
#define LOSS_STEPS 10
void flow_loss_watch(const struct physics_context *context);

#endif
