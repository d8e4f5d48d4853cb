/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows follow their particles: reordered, removed, extended, freed. Read history_rows.h first. */
#include "kernel/pairs/history_rows.h"
#include "base/memory.h"
#include "base/scan.h"
#include <string.h>

void history_rows_reorder(struct history_rows *rows, const uint32_t *order, size_t owned) {
    if (rows->start == NULL)
        return;
    size_t *start = memory_allocate(owned + 1, sizeof *start, "history rows");
    struct history_row *row = memory_allocate(rows->count, sizeof *row, "history rows");
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < owned; k++)
        start[k] = rows->start[order[k] + 1] - rows->start[order[k]];
    rows->count = scan_sizes(start, owned, start);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < owned; k++)
        memcpy(row + start[k], rows->row + rows->start[order[k]], (start[k + 1] - start[k]) * sizeof *row);
    memory_free(rows->start);
    memory_free(rows->row);
    rows->start = start;
    rows->row = row;
}

void history_rows_remove(struct history_rows *rows, const uint8_t *remove, size_t owned) {
    size_t kept = 0, at = 0;
    if (rows->start == NULL)
        return;
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

void history_rows_extend(struct history_rows *rows, size_t before, size_t after) {
    if (rows->start == NULL || before == after)
        return;
    rows->start = memory_resize(rows->start, after + 1, sizeof *rows->start, "history rows");
    for (size_t k = before + 1; k <= after; k++)
        rows->start[k] = rows->start[before];
}

void history_rows_free(struct history_rows *rows) {
    memory_free(rows->start);
    memory_free(rows->row);
    *rows = (struct history_rows){0};
}
