/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles that cross a plane, without a look at each step: a particle has a number that grows by 1 when the particle
 * crosses the plane along its normal, and falls by 1 when the particle crosses back. In an open direction the number is 1
 * behind the plane and 0 before the plane; along a periodic direction crossings of the box count, too, as each period
 * holds one image of the plane. So the net crossings since the start are the sum of all numbers, less that at the start,
 * less the numbers of particles at their insertion, plus the numbers at their deletion. */
#ifndef SCREE_OBSERVE_CROSSING_H
#define SCREE_OBSERVE_CROSSING_H

#include "base/error.h"
#include "data/formats/output_options.h"
#include "kernel/particles/particles.h"

/* The number of particle i. Any thread. */
double crossing_number(const struct box *box, const struct output_plane *plane,
                       const struct particles *particles, size_t i);

/* Fails (user) if the normal has no direction, or leans along a periodic direction without being along it, or is along a
 * periodic direction of a box that moves. */
bool crossing_check(const struct box *box, const struct output_plane *plane, struct error *error);

#endif
