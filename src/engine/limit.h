/* SPDX-License-Identifier: BSD-3-Clause */
/* The stable step of the contacts that there are: what integrate/stability.h finds, over all ranks. */
#ifndef SCREE_ENGINE_LIMIT_H
#define SCREE_ENGINE_LIMIT_H

#include "engine/state.h"

/* A step of at most `most` that is stable for the present contacts: `most` itself where it is. Never
 * above the true limit of these contacts, and equal to it where the bound of stability.h is sharp. Needs
 * pairs and, with several ranks, copies that stand where their originals do. Collective; all ranks get the
 * same. */
double limit_of_contacts(struct simulation *simulation, double most);

#endif
