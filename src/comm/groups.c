#include "comm/groups.h"

#include "core/memory.h"

#include <assert.h>

void groups_make(struct groups *groups, const int *rank, size_t n, int size) {
    size_t *place = memory_allocate_zero((size_t)size, sizeof *place, "items per rank");
    size_t count = 0;
    for (size_t k = 0; k < n; k++) {
        assert(rank[k] >= 0 && rank[k] < size);
        if (place[rank[k]]++ == 0)
            count++;
    }
    groups->count = count;
    groups->rank = memory_allocate(count, sizeof *groups->rank, "neighbour ranks");
    groups->start = memory_allocate(count + 1, sizeof *groups->start, "neighbour ranks");
    groups->item = memory_allocate(n, sizeof *groups->item, "items by rank");
    size_t g = 0, first = 0;
    for (int r = 0; r < size; r++) {
        if (place[r] == 0)
            continue;
        groups->rank[g] = r;
        groups->start[g++] = first;
        size_t here = place[r];
        place[r] = first;
        first += here;
    }
    groups->start[count] = n;
    for (size_t k = 0; k < n; k++)
        groups->item[place[rank[k]]++] = (uint32_t)k;
    memory_free(place);
}

void groups_free(struct groups *groups) {
    memory_free(groups->rank);
    memory_free(groups->start);
    memory_free(groups->item);
    *groups = (struct groups){0};
}
