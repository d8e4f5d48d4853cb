/* SPDX-License-Identifier: BSD-3-Clause */
/* Size classes from the radii on all ranks. */
#ifndef SCREE_ENGINE_CLASSIFY_H
#define SCREE_ENGINE_CLASSIFY_H

#include "engine/state.h"

/* Chooses size classes from the radii on all ranks, counts their populations, and sets the margins that the
 * interactions need. Collective. */
bool classify_choose(struct simulation *simulation, struct error *error);

#endif
