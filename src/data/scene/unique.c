/* SPDX-License-Identifier: BSD-3-Clause */
/* Sorts keys and finds the first that occurs twice. Read source_makers.h first. */
#include "data/scene/source_makers.h"

#include "base/memory.h"

#include <stdlib.h>

void unique_reserve(struct unique *unique, size_t capacity) {
    if (capacity <= unique->capacity)
        return;
    unique->capacity = capacity;
    unique->entry = memory_resize(unique->entry, capacity, sizeof(*unique->entry), "ids seen");
}

void unique_add(struct unique *unique, const struct unique_entry *entry) {
    if (unique->count == unique->capacity)
        unique_reserve(unique, unique->capacity ? 2 * unique->capacity : 1024);
    unique->entry[unique->count++] = *entry;
}

static int by_key(const void *a, const void *b) {
    const struct unique_entry *p = a, *q = b;
    if (p->key != q->key)
        return p->key < q->key ? -1 : 1;
    if (p->source != q->source)
        return p->source < q->source ? -1 : 1;
    return p->line < q->line ? -1 : p->line > q->line;
}

bool unique_find_twice(struct unique *unique, const struct unique_entry **first,
                       const struct unique_entry **second) {
    if (unique->count > 1)
        qsort(unique->entry, unique->count, sizeof(*unique->entry), by_key);
    for (size_t k = 1; k < unique->count; k++)
        if (unique->entry[k].key == unique->entry[k - 1].key) {
            *first = &unique->entry[k - 1];
            *second = &unique->entry[k];
            return true;
        }
    return false;
}

void unique_free(struct unique *unique) {
    memory_free(unique->entry);
    *unique = (struct unique){0};
}
