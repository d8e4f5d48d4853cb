/* SPDX-License-Identifier: BSD-3-Clause */
/* The particles of a fluid at the start: on a lattice, fluid particles where the region is free of grains and walls,
 * boundary particles in grains and behind walls, up to the support below the surface. */
#ifndef SCREE_LATTICE_LATTICE_FILL_H
#define SCREE_LATTICE_LATTICE_FILL_H

#include "engine/physics.h"

/* As `check` of struct physics: all that the scene says of the fluid and of what bounds it goes together. */
bool lattice_fill_suits(const struct physics_context *context, struct error *error);

/* As `fill` of struct physics. */
bool lattice_fill_run(const struct physics_context *context, const struct physics_share *share,
                      struct error *error);

/* In place of lattice_fill_run where particles come from a checkpoint or an earlier stage: grains, walls, open sides and spacing are
 * such as these particles can have; else a user's error on all ranks, and particles of bodies that are missing have none. Collective. */
bool lattice_fill_kept_suits(const struct physics_context *context, struct error *error);

#endif
