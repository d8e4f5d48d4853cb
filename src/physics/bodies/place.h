/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes bodies of grains. */
#ifndef SCREE_BODIES_PLACE_H
#define SCREE_BODIES_PLACE_H

#include "physics/bodies/bodies.h"

/* The clump that a grain of this material and radius becomes; -1: none. */
int place_clump(const struct bodies_options *options, int material, double radius);

/* Turns the grains of this rank that are to be bodies into bodies and their members: `fill` of struct physics. */
bool place_all(struct bodies *bodies, const struct physics_context *context,
               const struct physics_share *share, struct error *error);

#endif
