/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains: the physics that every scene has (physics.h). */
#ifndef SCREE_ENGINE_GRAINS_H
#define SCREE_ENGINE_GRAINS_H

#include "engine/state.h"

/* `self` of this physics is the struct simulation, the options are the struct law. */
extern const struct physics grains_physics;

#endif
