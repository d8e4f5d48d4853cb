/* SPDX-License-Identifier: BSD-3-Clause */
/* The scenes that go with grains in which the flow is rigid (rigid_step.h). */
#ifndef SCREE_COUPLING_RIGID_SUITS_H
#define SCREE_COUPLING_RIGID_SUITS_H

#include "engine/physics.h"

/* True if the keys go together with `coupling: rigid`, or the coupling is another; else a user's error with the key. */
bool rigid_suits(const struct physics_context *context, struct error *error);

#endif
