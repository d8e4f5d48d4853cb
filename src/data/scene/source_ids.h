/* SPDX-License-Identifier: BSD-3-Clause */
/* Ids of the particles of a scene. An id that a file or the scene names stands. The particles without one are
 * numbered from 1 on, in the order of the sources; the numbers leave out all ids that are named. So the ids
 * depend on the scene alone, and a new id clashes with no other. */
#ifndef SCREE_SCENE_SOURCE_IDS_H
#define SCREE_SCENE_SOURCE_IDS_H

#include "data/scene/source_sphere.h"

/* Zeroed: no id is named yet. */
struct source_ids {
    int64_t *named; /* by all sources; sorted by source_ids_begin */
    size_t count, passed;
    int64_t last; /* new id */
};

/* Collects the ids that the sources name; `batch`: those of all sources, in their order. One thread. */
void source_ids_begin(struct source_ids *ids, const struct scene *scene, const struct source_batch *batch);

/* The id of row `row`; new ids are given in the order of the calls. */
int64_t source_ids_give(struct source_ids *ids, const struct source_options *options,
                        const struct source_batch *batch, size_t row);

void source_ids_free(struct source_ids *ids);

#endif
