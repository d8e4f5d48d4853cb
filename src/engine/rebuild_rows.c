/* SPDX-License-Identifier: BSD-3-Clause */
/* Contact histories become rows, which go with their particles to other ranks. */
#include "engine/rebuild_rows.h"
#include "base/memory.h"

void rebuild_detach_obstacles(const struct physics_set *set, struct rebuild_rows *rows) {
    const struct physics_active *obstacles = set->obstacles;
    if (obstacles)
        obstacles->row->obstacles->detach(&obstacles->context, &rows->obstacles);
}

void rebuild_detach(const struct search *search, const struct physics_set *set,
                    const struct particles *particles, bool both_ends, struct rebuild_rows *rows) {
    if (search->history)
        history_detach(search->history, search->list, particles, both_ends, &rows->pairs);
    rebuild_detach_obstacles(set, rows);
}

void rebuild_part(struct simulation *s, struct rebuild_rows *rows) {
    rows->before = rows->stay = s->particles->owned;
    rows->place = memory_allocate(rows->before, sizeof *rows->place, "places of particles");
    if (!rows->stays) {
        rows->stay = migrate_places(s->comm, s->ranks.domain, s->particles, rows->place);
        return;
    }
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < rows->before; k++)
        rows->place[k] = (uint32_t)k;
}

void rebuild_loosen(struct simulation *s, struct rebuild_rows *rows) {
    history_loosen(s->search.history, s->search.list, s->particles, rows->place, &rows->loose, &rows->leave);
}

/* After the migration: the rows of the arrivals join the loose rows, and the arrivals join the particles that
 * may be partners, which get the numbers of their places. */
static void loose_settle(const struct particles *particles, struct rebuild_rows *rows) {
    size_t arrivals = particles->owned - rows->stay, n = 0;
    history_loose_join(&rows->loose, &rows->leave);
    for (size_t k = 0; k < rows->near_count; k++)
        if (rows->place[rows->near[k]] != PARTICLE_LEFT)
            rows->near[n++] = rows->place[rows->near[k]];
    rows->near = memory_resize(rows->near, n + arrivals, sizeof *rows->near, "partners of rows");
    for (size_t k = rows->stay; k < particles->owned; k++)
        rows->near[n++] = (uint32_t)k;
    rows->near_count = n;
}

int rebuild_rows_list(struct rebuild_rows *rows, struct history_rows *list[REBUILD_SETS]) {
    int n = 0;
    if (rows->pairs.start)
        list[n++] = &rows->pairs;
    if (rows->obstacles.start)
        list[n++] = &rows->obstacles;
    for (int k = 0; k < PHYSICS_COUNT; k++)
        if (rows->carried[k] && rows->carried[k]->start)
            list[n++] = rows->carried[k];
    return n;
}

void rebuild_migrate(struct simulation *s, struct rebuild_rows *rows) {
    struct history_rows *list[REBUILD_SETS];
    struct migrate_rows set[REBUILD_SETS + 1];
    const struct migrate_places places = {rows->place, rows->stay};
    const bool loose = rows->leave.carrier != NULL;
    int n = rebuild_rows_list(rows, list);
    for (int k = 0; k < n; k++)
        set[k] = (struct migrate_rows){.start = list[k]->start,
                                       .row = list[k]->row,
                                       .count = list[k]->count,
                                       .row_bytes = sizeof *list[k]->row,
                                       .sent = history_row_bytes(list[k]->components)};
    if (loose)
        set[n] = (struct migrate_rows){.row = rows->leave.row,
                                       .count = rows->leave.count,
                                       .row_bytes = sizeof *rows->leave.row,
                                       .sent = history_row_bytes(s->search.history->components),
                                       .carrier = rows->leave.carrier};
    ghosts_migrate_rows(s->ranks.ghosts, s->particles, &places, set, n + loose);
    for (int k = 0; k < n; k++)
        *list[k] = (struct history_rows){set[k].start, set[k].row, set[k].count, list[k]->components};
    if (loose) {
        rows->leave = (struct history_loose){set[n].carrier, set[n].row, set[n].count};
        loose_settle(s->particles, rows);
    }
}

void rebuild_rows_free(struct rebuild_rows *rows) {
    history_rows_free(&rows->pairs);
    history_kept_free(&rows->kept);
    history_loose_free(&rows->loose);
    history_loose_free(&rows->leave);
    memory_free(rows->near);
    memory_free(rows->place);
    memory_free(rows->order);
    history_rows_free(&rows->obstacles);
    *rows = (struct rebuild_rows){0};
}
