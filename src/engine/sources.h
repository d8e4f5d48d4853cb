/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles that come and go during a run. */
#ifndef SCREE_ENGINE_SOURCES_H
#define SCREE_ENGINE_SOURCES_H

#include "engine/rebuild_rows.h"

/* Removes particles that leave or are deleted, and inserts particles; at a rebuild, while there are no
 * ghosts. Collective. */
void sources_run(struct simulation *simulation, struct rebuild_rows *rows);

/* True if this step must rebuild because a source or a deletion is due. */
bool sources_due(const struct sources *sources, const struct scene *scene, const struct clock *clock);

/* Prepares the insertion regions; refuses a region that cannot hold its largest particle. */
bool sources_prepare(struct sources *sources, const struct scene *scene, struct error *error);

/* Weighs what insertions with a mass rate insert, once the physics are there. */
void sources_weigh(struct sources *sources, const struct scene *scene, const struct physics_set *set);

/* Adds a particle at the next rebuild; positions are box-relative, inside the box. Deletes the particle `id` at the
 * next rebuild, with its body if it has one. The same on all ranks. */
void sources_give(struct given *given, const struct insertion_candidate *candidate);
void sources_take(struct given *given, int64_t id);
void sources_free(struct sources *sources);

/* The number of particles that insertion region `k` should have placed from the start of the run to the last
 * check of the region. */
uint64_t sources_asked(const struct sources *sources, const struct clock *clock, int k);

#endif
