/* SPDX-License-Identifier: BSD-3-Clause */
/* The stages of a scene in a simulation of the library (engine/run_stages.h). */
#ifndef SCREE_LIBRARY_SCREE_STAGES_H
#define SCREE_LIBRARY_SCREE_STAGES_H

#include "front/library/scree_parts.h"

/* Takes the scene of the stage with which the simulation begins: that of the checkpoint `resume`, or the first (NULL).
 * Does nothing without stages. Fails (user) if all stages are over. Collective. */
bool scree_stages_first(struct scree_simulation *simulation, const char *resume, struct error *error);

/* Prepares the conditions of the present stage, and tells the caller which stage it is. */
bool scree_stages_begin(struct scree_simulation *simulation, struct error *error);

/* True if the conditions are looked at after step `number`, and need the sums of its forces. */
bool scree_stages_want_sums(const struct scree_simulation *simulation, uint64_t number);

/* True if step `number` is the last of the present stage, as far as is known; it must rebuild. */
bool scree_stages_last(const struct scree_simulation *simulation, uint64_t number);

/* Looks at the conditions after a step. If the step was the last of its stage, the simulation of the next stage takes
 * the place of the present one. Collective. */
bool scree_stages_advance(struct scree_simulation *simulation, struct error *error);

/* True if the last stage has ended. */
bool scree_stages_over(const struct scree_simulation *simulation);

#endif
