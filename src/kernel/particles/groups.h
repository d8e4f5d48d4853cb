/* SPDX-License-Identifier: BSD-3-Clause */
/* The groups of particles, whose motion may be prescribed (integrator.h). Registered if a scene has groups
 * other than "free". */
#ifndef SCREE_PARTICLES_GROUPS_H
#define SCREE_PARTICLES_GROUPS_H

#include "kernel/particles/particles.h"

/* Registers `group`, and `density`: the inverse mass is 0 while motion is prescribed, the density stays. */
void groups_register(struct particles *particles);

/* The group of each particle, an index into the scene's groups, 0 = free; NULL if all are free. Borrowed
 * until the set grows. */
uint8_t *groups_of(const struct particles *particles);

/* Mass / volume of each particle; NULL where all are free. */
double *groups_densities(const struct particles *particles);

/* Mass of particle i, also where its motion is prescribed. */
double groups_mass(const struct particles *particles, size_t i);

#endif
