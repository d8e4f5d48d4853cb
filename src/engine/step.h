/* SPDX-License-Identifier: BSD-3-Clause */
/* One time step; step.c describes the order of passes. */
#ifndef SCREE_ENGINE_STEP_H
#define SCREE_ENGINE_STEP_H

#include "engine/state.h"

/* step_plan makes the list of passes from the scene; step_plan_print prints the list. */
void step_plan(struct simulation *simulation);
void step_plan_print(const struct step_plan *plan, bool fused, FILE *file);

/* One step: advance, rebuild or exchange, forces. `rebuild` forces a rebuild. Collective. */
void step_run(struct simulation *simulation, bool rebuild);

/* Computes forces at the present positions without advancing, for the start of a run. The history stays.
 * Collective. */
void step_forces(struct simulation *simulation);

#endif
