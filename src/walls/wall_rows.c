/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of wall history between ranks: reordered, removed, freed. Read wall.h first. */
#include "walls/wall.h"
#include "core/memory.h"
#include <string.h>

void wall_rows_reorder(struct wall_rows *rows, const uint32_t *order, size_t owned) {
    size_t *start = memory_allocate(owned + 1, sizeof *start, "wall history");
    struct wall_row *row = memory_allocate(rows->count, sizeof *row, "wall history");
    size_t at = 0;
    for (size_t k = 0; k < owned; k++) {
        size_t first = rows->start[order[k]], count = rows->start[order[k] + 1] - first;
        start[k] = at;
        memcpy(row + at, rows->row + first, count * sizeof *row);
        at += count;
    }
    start[owned] = at;
    memory_free(rows->start);
    memory_free(rows->row);
    rows->start = start;
    rows->row = row;
    rows->count = at;
}

void wall_rows_remove(struct wall_rows *rows, const uint8_t *remove, size_t owned) {
    size_t kept = 0, at = 0;
    for (size_t k = 0; k < owned; k++) {
        size_t first = rows->start[k], count = rows->start[k + 1] - first;
        if (remove[k])
            continue;
        memmove(rows->row + at, rows->row + first, count * sizeof *rows->row);
        rows->start[kept++] = at;
        at += count;
    }
    rows->start[kept] = at;
    rows->count = at;
}

void wall_rows_free(struct wall_rows *rows) {
    memory_free(rows->start);
    memory_free(rows->row);
    *rows = (struct wall_rows){0};
}
