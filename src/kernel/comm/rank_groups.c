/* SPDX-License-Identifier: BSD-3-Clause */
/* Sorts items by rank, with a small table of the ranks that occur. Read rank_groups.h first. */
#include "kernel/comm/rank_groups.h"

#include "base/memory.h"

#include <assert.h>
#include <stdlib.h>

/* A rank that occurs, with its number of items. */
struct occurrence {
    int rank;
    uint32_t number; /* number of the rank, in the order of first occurrence */
    size_t items;
};

/* The ranks that occur: found by open addressing, so that time and memory do not depend on the number of
 * ranks of the run. */
struct occurrences {
    struct occurrence *list;
    size_t count;
    uint32_t *slot; /* number + 1 of the rank that hashes here; 0: free */
    size_t slots;   /* a power of two, more than twice `count` */
};

static size_t slot_of(const struct occurrences *seen, int rank) {
    size_t k = (uint32_t)rank * 0x9e3779b9u >> 7 & (seen->slots - 1);
    while (seen->slot[k] > 0 && seen->list[seen->slot[k] - 1].rank != rank)
        k = (k + 1) & (seen->slots - 1);
    return k;
}

static void occurrences_grow(struct occurrences *seen) {
    seen->slots = seen->slots > 0 ? 2 * seen->slots : 128;
    memory_free(seen->slot);
    seen->slot = memory_allocate_zero(seen->slots, sizeof *seen->slot, "neighbour ranks");
    seen->list = memory_resize(seen->list, seen->slots / 2, sizeof *seen->list, "neighbour ranks");
    for (size_t k = 0; k < seen->count; k++)
        seen->slot[slot_of(seen, seen->list[k].rank)] = (uint32_t)k + 1;
}

/* The number of a rank; a new rank gets the next number. */
static uint32_t number_of(struct occurrences *seen, int rank) {
    size_t k = slot_of(seen, rank);
    if (seen->slot[k] == 0) {
        if (2 * (seen->count + 1) >= seen->slots) {
            occurrences_grow(seen);
            k = slot_of(seen, rank);
        }
        seen->list[seen->count] = (struct occurrence){.rank = rank, .number = (uint32_t)seen->count};
        seen->slot[k] = (uint32_t)++seen->count;
    }
    return seen->slot[k] - 1;
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
    memory_free(seen.slot);
    memory_free(seen.list);
}

void rank_groups_free(struct groups *groups) {
    memory_free(groups->rank);
    memory_free(groups->start);
    memory_free(groups->item);
    *groups = (struct groups){0};
}
