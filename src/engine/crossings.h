/* SPDX-License-Identifier: BSD-3-Clause */
/* Net crossings of the planes that the observables ask for (data/observe/crossing.h): the part of the sum that does not follow
 * from the particles of the moment. */
#ifndef SCREE_ENGINE_CROSSINGS_H
#define SCREE_ENGINE_CROSSINGS_H

#include "data/formats/output.h"
#include "data/formats/restart.h"
#include "kernel/particles/box.h"
#include "kernel/particles/particles.h"

/* Before particles are made or read: no sum is known. */
void crossings_prepare(struct output_crossing *crossing, int planes);

/* With the particles of the start, or of a checkpoint, which may lack the sums of new planes: these begin now. */
void crossings_begin(struct output_crossing *crossing, const struct observables_options *options,
                     const struct box *box, const struct particles *particles);

/* Particle i, owned, is about to be deleted (sign 1), or was inserted (sign -1). */
void crossings_account(struct output_crossing *crossing, const struct observables_options *options,
                       const struct box *box, const struct particles *particles, size_t i, double sign);

/* Adds the numbers that a resume needs. */
void crossings_restart(struct output_crossing *crossing, const struct observables_options *options,
                       struct restart *restart);

#endif
