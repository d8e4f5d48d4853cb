/* SPDX-License-Identifier: BSD-3-Clause */
/* Turns contact histories into rows. */
#include "engine/rebuild_rows.h"
#include "core/memory.h"

void rebuild_detach(struct simulation *s, bool both_ends, struct rebuild_rows *rows) {
    *rows = (struct rebuild_rows){0};
    if (s->grains.history)
        history_detach(s->grains.history, s->grains.list, s->particles, both_ends, &rows->pairs);
    if (s->grains.walls && s->grains.law.history_components)
        walls_detach(s->grains.walls, s->particles, &rows->walls);
}

void rebuild_carry(struct simulation *s, struct rebuild_rows *rows) {
    physics_rows(&s->physics, rows->carried, rows->components);
}

void rebuild_rows_free(struct rebuild_rows *rows) {
    history_rows_free(&rows->pairs);
    history_kept_free(&rows->kept);
    history_loose_free(&rows->loose);
    history_loose_free(&rows->leave);
    memory_free(rows->near);
    memory_free(rows->place);
    memory_free(rows->order);
    wall_rows_free(&rows->walls);
    *rows = (struct rebuild_rows){0};
}
