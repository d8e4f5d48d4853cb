/* SPDX-License-Identifier: BSD-3-Clause */
/* A hash table of numbers 0, 1, 2 ..., in chains: which numbers have a key? The table keeps no keys. What a number stands
 * for lies with the caller, who compares, as a chain also holds numbers of other keys:
 *
 *   for (uint32_t n = hash_first(&table, key); n != HASH_END; n = table.next[n])
 *       if (id[n] == key)
 *           ...
 *
 * Several numbers may have one key. A zeroed table has no room. */
#ifndef SCREE_BASE_HASH_H
#define SCREE_BASE_HASH_H

#include "base/mix.h"

#include <stdatomic.h>
#include <stddef.h>

#define HASH_END UINT32_MAX

struct hash {
    _Atomic uint32_t *first; /* the number put last into each chain, or HASH_END */
    uint32_t *next;          /* the number behind each number in its chain, or HASH_END */
    size_t room;             /* numbers below it can be put in; there are twice as many chains */
    size_t capacity;         /* the largest room so far */
    unsigned shift;          /* of the top bits of a product, which are the chain of a key */
};

/* Empties the table and makes room for numbers below `numbers`, at least. `what` names the memory in a message. */
void hash_start(struct hash *hash, size_t numbers, const char *what);

void hash_free(struct hash *hash);

/* Bytes held. */
size_t hash_memory(const struct hash *hash);

static inline size_t hash_chain(const struct hash *hash, uint64_t key) {
    return (size_t)((key * MIX_GOLDEN) >> hash->shift);
}

/* The first number of the chain of a key, or HASH_END. Any thread, but not beside hash_put. */
static inline uint32_t hash_first(const struct hash *hash, uint64_t key) {
    return atomic_load_explicit(&hash->first[hash_chain(hash, key)], memory_order_relaxed);
}

/* Puts a number, below `room` and not yet in the table, under its key. Several threads may put at a time; the order in
 * a chain then depends on them. */
static inline void hash_put(struct hash *hash, uint64_t key, uint32_t number) {
    hash->next[number] =
        atomic_exchange_explicit(&hash->first[hash_chain(hash, key)], number, memory_order_relaxed);
}

#endif
