/* SPDX-License-Identifier: BSD-3-Clause */
/* The memory of a hash table. Read hash.h first. */
#include "base/hash.h"

#include "base/memory.h"

#include <assert.h>
#include <string.h>

enum { LEAST_BITS = 5 };

void hash_start(struct hash *hash, size_t numbers, const char *what) {
    unsigned bits = LEAST_BITS;
    assert(numbers <= HASH_END);
    while ((size_t)1 << bits < numbers)
        bits++;
    hash->room = (size_t)1 << bits;
    hash->shift = 64 - (bits + 1);
    if (hash->room > hash->capacity) {
        memory_free(hash->first);
        memory_free(hash->next);
        hash->capacity = hash->room;
        hash->first = memory_allocate(2 * hash->room, sizeof *hash->first, what);
        hash->next = memory_allocate(hash->room, sizeof *hash->next, what);
    }
    memset(hash->first, 0xff, 2 * hash->room * sizeof *hash->first);
}

void hash_free(struct hash *hash) {
    memory_free(hash->first);
    memory_free(hash->next);
    *hash = (struct hash){0};
}

size_t hash_memory(const struct hash *hash) {
    return hash->capacity * (2 * sizeof *hash->first + sizeof *hash->next);
}
