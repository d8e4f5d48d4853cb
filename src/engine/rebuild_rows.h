/* SPDX-License-Identifier: BSD-3-Clause */
/* Contact histories on the move, over a rebuild or into a checkpoint. */
#ifndef SCREE_ENGINE_REBUILD_ROWS_H
#define SCREE_ENGINE_REBUILD_ROWS_H

#include "engine/state.h"
#include "pairs/history_keep.h"
#include "walls/wall.h"

/* Contact history (pairs and walls together) on the move over a rebuild or into a checkpoint. */
struct rebuild_rows {
    struct history_rows pairs;
    bool keep; /* the short way, where particles neither come nor go: records of pairs that stay on this rank
                */
    uint32_t *place; /* several ranks: number after the migration of each of `before` particles */
    size_t before;
    uint32_t *order;          /* new particle k is old order[k] */
    struct history_kept kept; /* made between reorder and search */
    struct wall_rows walls;
};
void rebuild_detach(struct simulation *simulation, bool both_ends, struct rebuild_rows *rows);
void rebuild_rows_free(struct rebuild_rows *rows);

#endif
