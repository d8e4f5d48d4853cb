/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds keys that occur twice in a stream: keys are collected, sorted once, and neighbours compared. */
#ifndef SCREE_SCENE_UNIQUE_H
#define SCREE_SCENE_UNIQUE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct unique_entry {
    uint64_t key;          /* a hash: equal keys count as equal things */
    int64_t id;            /* of the particle */
    uint32_t line, source; /* place of the entry; order among equal keys */
};

/* Zeroed: empty. */
struct unique {
    struct unique_entry *entry;
    size_t count, capacity;
};

/* Makes room for `capacity` entries. */
void unique_reserve(struct unique *unique, size_t capacity);
void unique_add(struct unique *unique, const struct unique_entry *entry);

/* Sorts, and gives the first two entries of one key (in the order of source and line); false if all differ.
 */
bool unique_find_twice(struct unique *unique, const struct unique_entry **first,
                       const struct unique_entry **second);

void unique_free(struct unique *unique);

#endif
