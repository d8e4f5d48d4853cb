/* SPDX-License-Identifier: BSD-3-Clause */
/* Sorts items by rank, with a small table of the ranks that occur. Read rank_groups.h first. */
#include "kernel/comm/rank_groups.h"

#include "base/memory.h"
#include "base/hash.h"

#include <assert.h>
#include <stdlib.h>

/* A rank that occurs, with its number of items. */
struct occurrence {
    int rank;
    uint32_t number; /* number of the rank, in the order of first occurrence */
    size_t items;
};

/* The ranks that occur, in a table, so that time and memory do not depend on the number of ranks of the run. */
struct occurrences {
    struct occurrence *list; /* room for as many as the table */
    size_t count;
    struct hash by_rank;
};

static void occurrences_grow(struct occurrences *seen) {
    hash_start(&seen->by_rank, seen->count + 1, "neighbour ranks");
    seen->list = memory_resize(seen->list, seen->by_rank.room, sizeof *seen->list, "neighbour ranks");
    for (size_t k = 0; k < seen->count; k++)
        hash_put(&seen->by_rank, (uint64_t)seen->list[k].rank, (uint32_t)k);
}

/* The number of a rank; a new rank gets the next number. */
static uint32_t number_of(struct occurrences *seen, int rank) {
    if (seen->count == seen->by_rank.room)
        occurrences_grow(seen);
    for (uint32_t k = hash_first(&seen->by_rank, (uint64_t)rank); k != HASH_END; k = seen->by_rank.next[k])
        if (seen->list[k].rank == rank)
            return k;
    uint32_t number = (uint32_t)seen->count++;
    seen->list[number] = (struct occurrence){.rank = rank, .number = number};
    hash_put(&seen->by_rank, (uint64_t)rank, number);
    return number;
}

static int compare_ranks(const void *a, const void *b) {
    return ((const struct occurrence *)a)->rank - ((const struct occurrence *)b)->rank;
}

void rank_groups_make(struct groups *groups, const int *rank, size_t n, int size) {
    struct occurrences seen = {0};
    uint32_t *number = memory_allocate(n, sizeof *number, "items by rank");
    occurrences_grow(&seen);
    for (size_t k = 0; k < n; k++) {
        assert(rank[k] >= 0 && rank[k] < size);
        number[k] = k > 0 && rank[k] == rank[k - 1] ? number[k - 1] : number_of(&seen, rank[k]);
        seen.list[number[k]].items++;
    }
    (void)size;
    qsort(seen.list, seen.count, sizeof *seen.list, compare_ranks);
    groups->count = seen.count;
    groups->rank = memory_allocate(seen.count, sizeof *groups->rank, "neighbour ranks");
    groups->start = memory_allocate(seen.count + 1, sizeof *groups->start, "neighbour ranks");
    groups->item = memory_allocate(n, sizeof *groups->item, "items by rank");
    size_t *place = memory_allocate(seen.count, sizeof *place, "neighbour ranks"), first = 0;
    for (size_t g = 0; g < seen.count; g++) {
        groups->rank[g] = seen.list[g].rank;
        groups->start[g] = place[seen.list[g].number] = first;
        first += seen.list[g].items;
    }
    groups->start[seen.count] = n;
    for (size_t k = 0; k < n; k++)
        groups->item[place[number[k]]++] = (uint32_t)k;
    memory_free(place);
    memory_free(number);
    hash_free(&seen.by_rank);
    memory_free(seen.list);
}

void rank_groups_free(struct groups *groups) {
    memory_free(groups->rank);
    memory_free(groups->start);
    memory_free(groups->item);
    *groups = (struct groups){0};
}
