/* SPDX-License-Identifier: BSD-3-Clause */
/* Decides whether a rebuild is due. All ranks agree on a rebuild, and on the signals of a step, in one
 * reduction. */
#ifndef SCREE_ENGINE_DECIDE_H
#define SCREE_ENGINE_DECIDE_H

#include "engine/state.h"

/* decide_begin adds the last displacements of particles to the bounds, and starts to send bounds and signals
 * to all ranks. decide_end waits for the bounds and signals of all ranks (`alone`: there is one). Between the two calls other work
 * may be done. Collective. */
void decide_begin(struct simulation *simulation);
void decide_end(struct agree *agree, struct skin *skin, int classes, bool alone);

/* Measures the displacements if the bounds say that a rebuild may be due; sets signals.rebuild.
 * Collective. */
void decide_measure(struct agree *agree, struct skin *skin, const struct particles *particles,
                    const struct size_classes *classes, const struct comm *comm);

/* Replaces the bounds by the exact displacements, the two largest of each class on all ranks. Collective. */
void decide_displacements(struct skin *skin, const struct particles *particles, int classes,
                          const struct comm *comm);

/* Runs decide_begin, decide_end and decide_measure. */
void decide_run(struct simulation *simulation);

#endif
