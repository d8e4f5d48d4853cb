/* SPDX-License-Identifier: BSD-3-Clause */
/* The orders of a step, behind one door: a step chooses its order, runs its passes, and finishes. The plain order stands
 * in step.c; plan.h has what is in each.
 *
 * In fused order the particles of a block move just before the first pair that reads the particles, while
 * they are in the cache:
 *
 *     servo, walls
 *     early      (several ranks) particles that others read move (kernel/pairs/sweep.h); values leave for copies
 *     sweep      (one rank: early particles,) block by block: late particles move, then the block's forces
 *     receive    values arrive; meanwhile the ranks agree on bounds
 *     copies     forces of pairs with copies
 *     verify     if a particle has left its skin: rebuild, and compute the forces again
 *     wall, caller, finish, reverse
 *
 * In ring order, for steps after which nobody looks, particles come moved from the step before, or move first, and the
 * particles of a block move on to n+1 as soon as all their forces are there (kernel/pairs/ring.h):
 *
 *     servo, advance (only after a step in another order), walls, decide
 *     exchange   rebuild, or values leave for copies
 *     ring       block by block: forces, then the particles of which this was the last block move
 *     receive    values arrive
 *     copies     forces of pairs with copies, then the particles that waited for these move
 *     wall, finish, reverse
 *     settle     particles that others read, and those at walls, move
 *
 * Outside of this file and of order_plan.h nobody knows the order of a step: passes see rows and blocks, and evaluation->ring
 * (physics.h). */
#ifndef SCREE_ENGINE_ORDER_H
#define SCREE_ENGINE_ORDER_H

#include "engine/state.h"

/* The passes of the engine's own in the fused order and in the ring order, for plan_make. */
extern const struct engine_pass order_sweep[], order_ring[], order_settle[];

/* Prepares the orders that the scene has, once the plan is made. */
void order_make(struct simulation *simulation);

/* Chooses the order of the step that begins; `unseen` as in step_run. */
void order_choose(struct simulation *simulation, bool unseen);

/* Runs the passes of the step. */
void order_run(struct simulation *simulation);

/* True if the step has ended with all forces; else particles have moved on into the next step. */
bool order_finish(struct simulation *simulation);

/* Prints the plans of the orders other than the plain one. */
void order_print(const struct simulation *simulation, FILE *file);

#endif
