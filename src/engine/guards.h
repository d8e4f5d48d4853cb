/* SPDX-License-Identifier: BSD-3-Clause */
/* Guards: what stops a run (or warns, once) when its state is physical nonsense. They fill simulation->error
 * on the rank that sees it. */
#ifndef SCREE_ENGINE_GUARDS_H
#define SCREE_ENGINE_GUARDS_H

#include "engine/state.h"
#include "observe/observables.h"

/* Prepares the guard of energies, where asked for; refuses scenes that it cannot judge. The simulation is
 * whole but for its first forces. */
bool guards_prepare(struct simulation *simulation, struct error *error);
void guards_destroy(struct simulation *simulation);

/* What contacts that have become too stiff for the time step do (`text`), on all ranks alike. */
void guards_step(struct simulation *simulation, const char *text);

/* Overlap and speed after a force evaluation; free. */
void guards_check(struct simulation *simulation);

/* Positions and velocities that are no numbers; a pass over all particles. */
void guards_check_positions(struct simulation *simulation);

/* Particles that particles_wrap left outside of a periodic box, as it could not count their crossings; a pass
 * over all particles. */
void guards_check_images(struct simulation *simulation);

/* True if guards_check_energy is to follow that step, which then needs the energy sums. */
bool guards_energy_due(const struct simulation *simulation, uint64_t step);

/* Growth of energy without cause: kinetic + elastic + gravity + dissipated - work of walls, less what
 * particles that came or went took with them. Collective. */
void guards_check_energy(struct simulation *simulation);

#endif
