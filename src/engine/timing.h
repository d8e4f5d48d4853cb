/* SPDX-License-Identifier: BSD-3-Clause */
/* The time step of a run: chosen, refused, shortened. */
#ifndef SCREE_ENGINE_TIMING_H
#define SCREE_ENGINE_TIMING_H

#include "engine/state.h"

/* Stable time step and its limits from the particles present; sets dt or refuses. Collective. */
bool timing_choose(struct simulation *simulation, struct error *error);

/* The same for the contacts that there are, once pairs are known and before velocities are staggered;
 * shortens a step that is a fraction. Collective. */
bool timing_contacts(struct simulation *simulation, struct error *error);

/* During the run: true if timing_look is to follow that step; it looks whether contacts have become so stiff
 * that the step is nearly unstable, and then shortens it, if it is a fraction, or warns. Collective. */
bool timing_due(const struct simulation *simulation, uint64_t step);
void timing_look(struct simulation *simulation);

#endif
