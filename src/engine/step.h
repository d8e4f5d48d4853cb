/* SPDX-License-Identifier: BSD-3-Clause */
/* One time step (step.c tells it). */
#ifndef SCREE_ENGINE_STEP_H
#define SCREE_ENGINE_STEP_H

#include "engine/state.h"

/* Makes the list of passes from the scene; prints it. */
void step_plan(struct simulation *simulation);
void step_plan_print(const struct simulation *simulation, FILE *file);

/* One step: advance, rebuild or exchange, forces. `rebuild` forces a rebuild. Collective. */
void step_run(struct simulation *simulation, bool rebuild);

/* Forces at the present positions without advancing: the start of a run. history stays. Collective. */
void step_forces(struct simulation *simulation);

#endif
