/* SPDX-License-Identifier: BSD-3-Clause */
/* What a run learns of the solvers of its fluid: guards.residual, the place of a failure, rows of the report. */
#ifndef SCREE_SCHEMES_SOLVER_WATCH_H
#define SCREE_SCHEMES_SOLVER_WATCH_H

#include "engine/physics.h"

/* Starts the linear algebra of a fluid, if it is not there; false with the fluid's error. Collective. */
bool solver_watch_begin(const struct physics_context *context);

/* After a step of the flow: adds step and time to the error of a solver that failed; warns or stops, as guards.residual
 * says, of solves with a true residual far above the tolerance. Alike on all ranks. */
void solver_watch_step(const struct physics_context *context);

/* As `report` of struct physics_shown. */
void solver_watch_report(const struct physics_context *context, struct report_part *part);

#endif
