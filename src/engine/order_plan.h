/* SPDX-License-Identifier: BSD-3-Clause */
/* The plan of the visits of a step, from the pairs of a rebuild: for the orders of order.h. */
#ifndef SCREE_ENGINE_ORDER_PLAN_H
#define SCREE_ENGINE_ORDER_PLAN_H

#include "engine/state.h"

/* After a rebuild the plan is out of date; order_plan makes it, if it is, before a step needs it. */
void order_forget(struct simulation *simulation);
void order_plan(struct simulation *simulation);

/* The ranks agree at a rebuild whether the ring order pays on all of them; true if they must. Collective. */
bool order_needs_agreement(const struct simulation *simulation);
void order_agree(struct simulation *simulation);

#endif
