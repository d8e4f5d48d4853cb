/* SPDX-License-Identifier: BSD-3-Clause */
/* What a run will cost: steps, time on the clock, files. */
#ifndef SCREE_PROGRAM_RUN_COST_H
#define SCREE_PROGRAM_RUN_COST_H

#include "engine/simulation.h"

/* Prints, on rank 0, the number of steps, the time that they will take, and the files with their sizes, with `all` a line
 * each. For the
 * time the simulation runs some of its first steps, for about a third of a second; a simulation with a fluid is
 * not timed, as one of its steps may take long. The simulation must not be used for anything but its end
 * afterwards. Collective. */
void run_cost_print(struct simulation *simulation, bool all);

#endif
