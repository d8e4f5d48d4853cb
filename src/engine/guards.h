/* SPDX-License-Identifier: BSD-3-Clause */
/* Guards stop a run (or warn, once) when the state of the run is physical nonsense. A guard fills
 * simulation->error on the rank that finds the fault. */
#ifndef SCREE_ENGINE_GUARDS_H
#define SCREE_ENGINE_GUARDS_H

#include "engine/state.h"

/* Prepares the guard of energies, if the scene asks for it; refuses scenes that the guard cannot judge. The
 * simulation is complete except for the first forces. */
bool guards_prepare(struct simulation *simulation, struct error *error);

/* Runs the guards of all physics, and that of speed, after a force evaluation; costs no time. */
void guards_check(struct simulation *simulation);

/* Stops the run if a position, velocity, spin or force of an owned particle, or the motion of a wall or the force on it, is
 * not finite; a pass over all particles. Between two calls guards_check finds velocities and spins as particles move.
 * Places and velocities that are not finite become 0, so that a search ends. The error names step and time. */
void guards_check_finite(struct particles *particles, const struct box *box, const struct physics_set *set,
                         const struct clock *clock, struct error *error);

/* Finds particles that particles_wrap left outside of a periodic box because it could not count their
 * crossings; a pass over all particles. */
void guards_check_images(struct particles *particles, const struct box *box, const struct clock *clock,
                         struct error *error);

/* True if guards_check_energy is to follow that step, which then needs the energy sums. */
bool guards_energy_due(const struct guard_energy *energy, uint64_t step);

/* Checks the growth of energy without cause: kinetic + elastic + gravity + dissipated - work of walls,
 * without the energy of particles that came or went. Collective. */
void guards_check_energy(struct simulation *simulation);

#endif
