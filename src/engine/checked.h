/* SPDX-License-Identifier: BSD-3-Clause */
/* A step with all that belongs to it but files: sums for observables, checks, the length of the next step. */
#ifndef SCREE_ENGINE_CHECKED_H
#define SCREE_ENGINE_CHECKED_H

#include "engine/state.h"

/* Runs a step. `sums`: observables of its end are wanted. `rebuild` forces a rebuild that sorts. `seen`: the caller looks
 * at its end, so all numbers are checked to be finite. The caller has set simulation->agree.signals of
 * this rank; errors of guards are in simulation->error. Collective. */
void checked_step(struct simulation *simulation, bool sums, bool rebuild, bool seen);

#endif
