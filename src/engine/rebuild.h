/* SPDX-License-Identifier: BSD-3-Clause */
/* The rebuild; rebuild.c describes the passes. */
#ifndef SCREE_ENGINE_REBUILD_H
#define SCREE_ENGINE_REBUILD_H

#include "engine/rebuild_rows.h"

/* Full rebuild: history detached, particles wrapped, inserted, deleted and migrated, sorted unless they may stay, copied,
 * searched; history attached. Collective. */
void rebuild_run(struct simulation *simulation);

/* Prints the passes of a rebuild, a line each. */
void rebuild_print(const struct scene *scene, const struct ranks *ranks, const struct search *search,
                   const struct physics_set *set, FILE *file);

/* As rebuild_run, but with rows from a checkpoint; becomes the owner of the rows. */
void rebuild_from_rows(struct simulation *simulation, struct rebuild_rows *rows);

#endif
