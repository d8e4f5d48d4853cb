/* SPDX-License-Identifier: BSD-3-Clause */
/* The time step of a run: chosen, refused, shortened. */
#ifndef SCREE_ENGINE_TIMING_H
#define SCREE_ENGINE_TIMING_H

#include "engine/state.h"

/* Finds the stable time step and its limits from the particles present; sets dt, or refuses. Collective. */
bool timing_choose(struct simulation *simulation, struct error *error);

/* Does the same for the present contacts, after the search for pairs and before velocities are staggered;
 * shortens a step that is a fraction. Collective. */
bool timing_contacts(struct simulation *simulation, struct error *error);

/* timing_due: true if timing_look is to follow that step of the run. timing_look checks whether contacts have
 * become so stiff that the time step is nearly unstable; if so, timing_look shortens a time step that is a
 * fraction of the stable step, and warns otherwise. Collective. */
bool timing_due(const struct timing *timing, const struct scene *scene, uint64_t step);
void timing_look(struct simulation *simulation);

#endif
