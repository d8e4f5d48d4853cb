/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows follow their particles: reordered, removed, extended, freed. Read rowset.h first. */
#include "kernel/pairs/rowset.h"
#include "base/memory.h"
#include "base/scan.h"
#include <string.h>

void rowset_reorder(struct rowset *rows, const uint32_t *order, size_t owned) {
    if (rows->start == NULL)
        return;
    size_t *start = memory_allocate(owned + 1, sizeof *start, "history rows"), bytes = rows->bytes;
    char *row = memory_allocate(rows->count, bytes, "history rows");
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < owned; k++)
        start[k] = rows->start[order[k] + 1] - rows->start[order[k]];
    rows->count = scan_sizes(start, owned, start);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < owned; k++)
        memcpy(row + start[k] * bytes, (const char *)rows->row + rows->start[order[k]] * bytes,
               (start[k + 1] - start[k]) * bytes);
    memory_free(rows->start);
    memory_free(rows->row);
    rows->start = start;
    rows->row = row;
}

void rowset_remove(struct rowset *rows, const uint8_t *remove, size_t owned) {
    size_t kept = 0, at = 0;
    char *row = rows->row;
    if (rows->start == NULL)
        return;
    for (size_t k = 0; k < owned; k++) {
        size_t first = rows->start[k], count = rows->start[k + 1] - first;
        if (remove[k])
            continue;
        memmove(row + at * rows->bytes, row + first * rows->bytes, count * rows->bytes);
        rows->start[kept++] = at;
        at += count;
    }
    rows->start[kept] = at;
    rows->count = at;
}

size_t *rowset_extend(size_t *start, size_t before, size_t after) {
    if (start == NULL || before == after)
        return start;
    start = memory_resize(start, after + 1, sizeof *start, "history rows");
    for (size_t k = before + 1; k <= after; k++)
        start[k] = start[before];
    return start;
}

void rowset_free(struct rowset *rows) {
    memory_free(rows->start);
    memory_free(rows->row);
    *rows = (struct rowset){0};
}
