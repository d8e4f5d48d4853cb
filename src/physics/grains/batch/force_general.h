/* SPDX-License-Identifier: BSD-3-Clause */
/* Laws with parts one contact after another: pushes of a batch (force_kernel.h) for what has no vectorised loop. Scenes whose law
 * has no parts never come here. */
#ifndef SCREE_BATCH_FORCE_GENERAL_H
#define SCREE_BATCH_FORCE_GENERAL_H

#include "physics/grains/batch/force_kernel.h"

/* The normal direction alone: loops have the rest. */
void force_general_push(const struct law *law, struct law_step step, struct force_batch *batch);

/* The whole law: nothing is left to a loop. */
void force_general_respond(const struct law *law, struct law_step step, struct force_batch *batch);

#endif
