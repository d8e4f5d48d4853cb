/* SPDX-License-Identifier: BSD-3-Clause */
/* The general loop of the force loop: a batch of contacts of a law with parts, one after another or, without
 * energies, in vectorised loops where there are such. Scenes whose law has no parts never come here. */
#ifndef SCREE_BATCH_FORCE_GENERAL_H
#define SCREE_BATCH_FORCE_GENERAL_H

#include "physics/grains/batch/force_kernel.h"

/* The law over the first `count` contacts of a batch whose overlap ... spin, coefficients, extra, radius and
 * history are filled in: fills out, history, energy and `active`. */
void force_general_respond(const struct law *law, struct law_step step, struct force_batch *batch, int count);

/* The same for the pairs of a law that rubs, where no energies are asked for: the normal direction by thread->grip or one contact
 * after another, the rest in a vectorised loop. The same bits. */
void force_general_rub(const struct law *law, struct law_step step, struct force_thread *thread);

/* `compute` and `note` of the client for a law with parts. */
void force_general_compute(const struct walk_task *task, struct walk_batch *batch);
void force_general_note(const struct walk_task *task, struct walk_batch *batch);

#endif
