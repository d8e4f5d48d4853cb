/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows of observables of a simulation of the library. */
#ifndef SCREE_LIBRARY_SCREE_OBSERVE_H
#define SCREE_LIBRARY_SCREE_OBSERVE_H

#include "front/library/scree_parts.h"

/* Makes the columns, and the first row of a simulation that is not resumed. Collective. */
bool scree_observe_begin(struct scree_simulation *simulation, bool resumed, struct error *error);

/* Frees the columns; the rows stay. */
void scree_observe_end(struct scree_simulation *simulation);

/* Keeps the observables of this moment, which scree_observe then tells until scree_observe_drop. Collective. */
bool scree_observe_keep(struct scree_simulation *simulation, struct error *error);
void scree_observe_drop(struct scree_simulation *simulation);

/* True if a row is due after step `number`, which ends at `time`. */
bool scree_observe_due(const struct scree_simulation *simulation, uint64_t number, double time);

/* Records a row of this moment. Collective. */
bool scree_observe_record(struct scree_simulation *simulation, struct error *error);

#endif
