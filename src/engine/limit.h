/* SPDX-License-Identifier: BSD-3-Clause */
/* The stable step of the present contacts: the result of integrate/stability.h over all ranks. */
#ifndef SCREE_ENGINE_LIMIT_H
#define SCREE_ENGINE_LIMIT_H

#include "engine/state.h"

/* A step of at most `most` that is stable for the present contacts: `most` itself if `most` is stable. The
 * step is never above the true limit of these contacts, and equals the limit if the bound of stability.h is
 * sharp. Needs pairs and, with several ranks, copies at the positions of their originals. Collective; all
 * ranks get the same step. */
double limit_of_contacts(struct simulation *simulation, double most);

#endif
