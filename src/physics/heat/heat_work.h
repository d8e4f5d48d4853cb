/* SPDX-License-Identifier: BSD-3-Clause */
/* Heat from dissipation. The force loop writes down the work that each contact takes in a step and the energy that its
 * springs hold (struct force_work); a walk over the contacts adds half of both to each grain. What a grain loses in a step
 * is the work taken less the growth of the energy held: the energy of a spring that ends with its contact is lost, too, in the
 * step in which it is missing. The sum over grains is that of the observable energy_dissipated, to rounding. */
#ifndef SCREE_HEAT_HEAT_WORK_H
#define SCREE_HEAT_HEAT_WORK_H

#include "engine/physics.h"

struct heat_work;

/* Asks the force loop for the work of its contacts. The context is borrowed. */
struct heat_work *heat_work_create(const struct physics_context *context);
void heat_work_destroy(struct heat_work **work);

/* After each rebuild: room for the pairs of the new list. One thread. */
void heat_work_rebuilt(struct heat_work *work);

/* Adds the work of the contacts of this step to their grains, after all contacts have been computed. Opens its own
 * team. */
void heat_work_finish(struct heat_work *work);

/* The energy that grain i has lost in the last step; energy. Any thread. */
double heat_work_lost(const struct heat_work *work, size_t i);

/* Takes the energy that grain i has lost: the next step begins. Each thread its own grains. */
double heat_work_take(struct heat_work *work, size_t i);

#endif
