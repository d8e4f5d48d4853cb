/* SPDX-License-Identifier: BSD-3-Clause */
/* How far grains will overlap, from the scene alone.
 *
 * Two estimates, both over the smaller radius and without dampers. Two free particles, or one and a wall, meet: the
 * springs take the energy of the effective mass. And a grain that cannot move away, as a wall or other grains support
 * it, is squeezed by a particle of mass M: two springs in a row, with the same force, take M u^2 / 2. Let D and S be the
 * overlaps at which the contact with the particle and the one with the support would store all of it alone. With forces that grow as
 * overlap^(p - 1), the softer one, of max(D, S), overlaps by
 *
 *   max(D, S) (1 + (min(D, S) / max(D, S))^(p / (p - 1)))^(-1/p)
 *
 * as the energies (d_i / D_i)^p add up to 1 and equal forces mean d_i ~ D_i^(p / (p - 1)). The estimate is an upper
 * bound for one particle: the grain's mass counts as 0, and nothing but two contacts takes energy. The worst case is
 * the largest and heaviest particle on the smallest grain. The overlap grows as the modulus^(-1/p), and the duration
 * of contacts, and so the time step, as the overlap. */
#ifndef SCREE_GRAINS_OVERLAPS_H
#define SCREE_GRAINS_OVERLAPS_H

#include "physics/grains/grains.h"

/* Finds the overlaps, and the speed, of struct grains_stable, once the time step is chosen. Collective; all ranks find the
 * same. */
void overlaps_expect(const struct physics_context *context);

/* The factor of the modulus, or of k_n, with which the squeezed grain overlaps by no more than `bound`. */
double overlaps_stiffening(const struct overlaps *overlaps, double bound);

#endif
