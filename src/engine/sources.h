/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles that come and go during a run. */
#ifndef SCREE_ENGINE_SOURCES_H
#define SCREE_ENGINE_SOURCES_H

#include "engine/rebuild_rows.h"

/* Particles that leave, are deleted or inserted; at a rebuild, while there are no ghosts. Collective. */
void sources_run(struct simulation *simulation, struct rebuild_rows *rows);

/* True if this step must rebuild because a source or a deletion is due. */
bool sources_due(const struct simulation *simulation);

/* Prepares the insertion regions; refuses one that cannot hold the largest of its particles. */
bool sources_prepare(struct simulation *simulation, struct error *error);

/* Particles that insertion region `k` should have placed since the start of the run, when it was looked at
 * last. */
uint64_t sources_asked(const struct simulation *simulation, int k);

#endif
