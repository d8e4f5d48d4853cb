/* SPDX-License-Identifier: BSD-3-Clause */
/* Connected regions by flooding: node after node, each node once. Read regions.h first. */
#include "fluid/regions.h"
#include "core/memory.h"
#include <stdlib.h>

struct region_size {
    int64_t nodes;
    int32_t number; /* as found */
};

static const int around[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

/* Gives all fluid nodes that are joined to `start` the number of a region; `stack` has room for all nodes. Returns
 * how many they are. */
static int64_t flood(struct nodes *nodes, int64_t start, int32_t number, int64_t *stack) {
    int64_t depth = 0, count = 0;
    stack[depth++] = start;
    nodes->owner[start] = number;
    while (depth > 0) {
        int64_t node = stack[--depth];
        count++;
        for (int k = 0; k < 2 * nodes->dimension; k++) {
            int64_t next = nodes_neighbour(nodes, node, around[k]);
            if (next < 0 || nodes->state[next] != NODES_FLUID || nodes->owner[next] >= 0)
                continue;
            nodes->owner[next] = number;
            stack[depth++] = next;
        }
    }
    return count;
}

static int larger_first(const void *a, const void *b) {
    const struct region_size *x = a, *y = b;
    return x->nodes != y->nodes ? (x->nodes < y->nodes) - (x->nodes > y->nodes)
                                : (x->number > y->number) - (x->number < y->number);
}

/* Renumbers the regions by size; small ones become solid. */
static struct regions keep(struct nodes *nodes, struct region_size *size, int32_t found) {
    struct regions regions = {0};
    int32_t *to = memory_allocate((size_t)found, sizeof *to, "regions of fluid");
    qsort(size, (size_t)found, sizeof *size, larger_first);
    for (int32_t k = 0; k < found; k++) {
        bool kept = (double)size[k].nodes >= REGIONS_POCKET * (double)size[0].nodes;
        to[size[k].number] = kept ? k : REGIONS_NOBODY;
        regions.count += kept;
        *(kept ? &regions.fluid : &regions.pocket) += size[k].nodes;
    }
    for (int64_t node = 0; node < nodes->all; node++) {
        if (nodes->state[node] != NODES_FLUID)
            continue;
        nodes->owner[node] = to[nodes->owner[node]];
        if (nodes->owner[node] == REGIONS_NOBODY)
            nodes->state[node] = NODES_SOLID;
    }
    memory_free(to);
    return regions;
}

struct regions regions_find(struct nodes *nodes) {
    int32_t found = 0, room = 0;
    struct region_size *size = NULL;
    int64_t *stack = memory_allocate((size_t)nodes->all, sizeof *stack, "regions of fluid");
    for (int64_t node = 0; node < nodes->all; node++)
        if (nodes->state[node] == NODES_FLUID)
            nodes->owner[node] = -1;
    for (int64_t node = 0; node < nodes->all; node++) {
        if (nodes->state[node] != NODES_FLUID || nodes->owner[node] >= 0)
            continue;
        if (found == room) {
            room = 2 * room + 16;
            size = memory_resize(size, (size_t)room, sizeof *size, "regions of fluid");
        }
        size[found] = (struct region_size){flood(nodes, node, found, stack), found};
        found++;
    }
    memory_free(stack);
    struct regions regions = keep(nodes, size, found);
    memory_free(size);
    return regions;
}
