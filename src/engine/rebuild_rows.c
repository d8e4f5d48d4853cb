/* SPDX-License-Identifier: BSD-3-Clause */
/* Contact histories become rows, which go with their particles to other ranks. */
#include "engine/rebuild_rows.h"
#include "base/memory.h"

void rebuild_detach_obstacles(struct simulation *s, struct rebuild_rows *rows) {
    const struct physics_active *obstacles = s->physics.obstacles;
    if (obstacles)
        obstacles->row->obstacles->detach(&obstacles->context, &rows->obstacles);
}

void rebuild_detach(struct simulation *s, bool both_ends, struct rebuild_rows *rows) {
    if (s->search.history)
        history_detach(s->search.history, s->search.list, s->particles, both_ends, &rows->pairs);
    rebuild_detach_obstacles(s, rows);
}

void rebuild_carry(struct simulation *s, struct rebuild_rows *rows) {
    physics_rows(&s->physics, rows->carried, rows->components);
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
static void loose_settle(struct simulation *s, struct rebuild_rows *rows) {
    size_t arrivals = s->particles->owned - rows->stay, n = 0;
    history_loose_join(&rows->loose, &rows->leave);
    for (size_t k = 0; k < rows->near_count; k++)
        if (rows->place[rows->near[k]] != PARTICLE_LEFT)
            rows->near[n++] = rows->place[rows->near[k]];
    rows->near = memory_resize(rows->near, n + arrivals, sizeof *rows->near, "partners of rows");
    for (size_t k = rows->stay; k < s->particles->owned; k++)
        rows->near[n++] = (uint32_t)k;
    rows->near_count = n;
}

void rebuild_migrate(struct simulation *s, struct rebuild_rows *rows) {
    struct migrate_rows set[2 + PHYSICS_COUNT];
    int n = 0, pairs = -1, leave = -1, obstacles = -1, carried[PHYSICS_COUNT];
    const size_t sent = s->search.history ? history_row_bytes(s->search.history->components) : 0;
    if (rows->pairs.start) {
        pairs = n;
        set[n++] = (struct migrate_rows){
            rows->pairs.start, rows->pairs.row, rows->pairs.count, sizeof *rows->pairs.row, sent, NULL};
    }
    if (rows->leave.carrier) {
        leave = n;
        set[n++] = (struct migrate_rows){NULL, rows->leave.row,    rows->leave.count, sizeof *rows->leave.row,
                                         sent, rows->leave.carrier};
    }
    if (rows->obstacles.start) {
        obstacles = n;
        set[n++] = (struct migrate_rows){rows->obstacles.start, rows->obstacles.row,  rows->obstacles.count,
                                         rows->obstacles.bytes, rows->obstacles.sent, NULL};
    }
    for (int k = 0; k < PHYSICS_COUNT; k++) {
        const struct history_rows *own = rows->carried[k];
        carried[k] = n;
        if (own)
            set[n++] = (struct migrate_rows){
                own->start, own->row, own->count, sizeof *own->row, history_row_bytes(rows->components[k]),
                NULL};
    }
    const struct migrate_places places = {rows->place, rows->stay};
    ghosts_migrate_rows(s->ranks.ghosts, s->particles, &places, set, n);
    for (int k = 0; k < PHYSICS_COUNT; k++)
        if (rows->carried[k])
            *rows->carried[k] =
                (struct history_rows){set[carried[k]].start, set[carried[k]].row, set[carried[k]].count};
    if (pairs >= 0)
        rows->pairs = (struct history_rows){set[pairs].start, set[pairs].row, set[pairs].count};
    if (obstacles >= 0)
        rows->obstacles = (struct rowset){.start = set[obstacles].start,
                                          .row = set[obstacles].row,
                                          .count = set[obstacles].count,
                                          .bytes = set[obstacles].row_bytes,
                                          .sent = set[obstacles].sent};
    if (leave >= 0) {
        rows->leave = (struct history_loose){set[leave].carrier, set[leave].row, set[leave].count};
        loose_settle(s, rows);
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
    rowset_free(&rows->obstacles);
    *rows = (struct rebuild_rows){0};
}
