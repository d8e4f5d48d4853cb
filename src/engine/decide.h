/* SPDX-License-Identifier: BSD-3-Clause */
/* Is a rebuild due? All ranks agree on it, and on the signals of a step, in one reduction. */
#ifndef SCREE_ENGINE_DECIDE_H
#define SCREE_ENGINE_DECIDE_H

#include "engine/state.h"

/* Bounds grow by what particles have just moved; they and the signals are sent to all ranks. decide_end waits for
 * them. Between the two other work may be done. Collective. */
void decide_begin(struct simulation *simulation);
void decide_end(struct simulation *simulation);

/* Where the bounds say that a rebuild may be due, displacements are measured: signals.rebuild says the rest.
 * Collective. */
void decide_measure(struct simulation *simulation);

/* All three. */
void decide_run(struct simulation *simulation);

#endif
