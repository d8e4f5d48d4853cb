/* SPDX-License-Identifier: BSD-3-Clause */
/* The fused order of a step. The particles of a block move just before the first pair that reads the particles, while they
 * are in the cache:
 *
 *     servo, walls
 *     plan       after a rebuild: which particles move early (kernel/pairs/sweep.h)
 *     early      (several ranks) particles that others read move; values leave for copies
 *     sweep      (one rank: early particles,) block by block: late particles move, then the block's forces
 *     receive    values arrive; meanwhile the ranks agree on bounds
 *     copies     forces of pairs with copies
 *     verify     if a particle has left its skin: rebuild, and compute the forces again
 *     wall, caller, finish, reverse
 *
 * Passes do not know the order of a step: they see rows and blocks. */
#ifndef SCREE_ENGINE_FUSED_H
#define SCREE_ENGINE_FUSED_H

#include "engine/state.h"

/* The passes of the engine's own from the first move to the last sum over pairs of the sweep's list, for plan_make. */
extern const struct engine_pass fused_sweep[];

/* True if the step that begins has the fused order: the scene allows it (`fused`), and no rebuild is due, or will be after one
 * more step like the last. */
bool fused_due(bool fused, const struct step_signals *signals, const struct skin *skin,
               const struct size_classes *classes);

#endif
