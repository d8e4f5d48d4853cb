/* SPDX-License-Identifier: BSD-3-Clause */
/* A table of ids with open addressing, which all threads fill at a time: a slot holds the number of a particle
 * and is taken by one atomic exchange. Several particles may have one id: the original and its copies. */
#include "kernel/pairs/history_follow.h"
#include "base/memory.h"
#include "base/scan.h"
#include <stdatomic.h>

struct table {
    _Atomic uint32_t *slot; /* PARTICLE_LEFT: free */
    size_t mask;
    const int64_t *id; /* by number */
};

static size_t slot_of(const struct table *table, int64_t id) {
    uint64_t key = (uint64_t)id * 0x9e3779b97f4a7c15u;
    return (size_t)(key ^ key >> 32) & table->mask;
}

static void table_put(struct table *table, uint32_t number) {
    size_t k = slot_of(table, table->id[number]);
    for (;; k = (k + 1) & table->mask) {
        uint32_t unused = PARTICLE_LEFT;
        if (atomic_compare_exchange_strong_explicit(&table->slot[k], &unused, number, memory_order_relaxed,
                                                    memory_order_relaxed))
            return;
    }
}

/* Writes the particles with this id unless `match` is NULL; returns how many there are. */
static size_t table_find(const struct table *table, int64_t id, uint32_t row, struct history_match *match) {
    size_t found = 0;
    for (size_t k = slot_of(table, id);; k = (k + 1) & table->mask) {
        uint32_t number = atomic_load_explicit(&table->slot[k], memory_order_relaxed);
        if (number == PARTICLE_LEFT)
            return found;
        if (table->id[number] != id)
            continue;
        if (match)
            match[found] = (struct history_match){row, number};
        found++;
    }
}

static void table_fill(struct table *table, const struct history_followers *followers, const uint32_t *now) {
    const struct particles *particles = followers->particles;
    size_t all = followers->near_count + particles->ghosts, room = 64;
    while (room < 2 * all)
        room *= 2;
    *table = (struct table){memory_allocate(room, sizeof *table->slot, "ids of partners"), room - 1,
                            particles->id};
#pragma omp parallel
    {
#pragma omp for schedule(static)
        for (size_t k = 0; k < room; k++)
            atomic_init(&table->slot[k], PARTICLE_LEFT);
#pragma omp for schedule(static) nowait
        for (size_t k = 0; k < followers->near_count; k++)
            table_put(table, history_number(now, followers->near[k]));
#pragma omp for schedule(static)
        for (size_t k = 0; k < particles->ghosts; k++)
            table_put(table, (uint32_t)(particles->owned + k));
    }
}

struct history_match *history_follow(const struct history_followers *followers, const uint32_t *now,
                                     size_t *count) {
    const struct history_loose *loose = followers->loose;
    struct table table;
    table_fill(&table, followers, now);
    uint32_t *start = memory_allocate(loose->count + 1, sizeof *start, "partners of rows");
#pragma omp parallel for schedule(static)
    for (size_t r = 0; r < loose->count; r++)
        start[r] = (uint32_t)table_find(&table, loose->row[r].partner, (uint32_t)r, NULL);
    *count = scan_counts_narrow(start, loose->count, start);
    struct history_match *match = memory_allocate(*count, sizeof *match, "partners of rows");
#pragma omp parallel for schedule(static)
    for (size_t r = 0; r < loose->count; r++)
        table_find(&table, loose->row[r].partner, (uint32_t)r, match + start[r]);
    memory_free(start);
    memory_free(table.slot);
    return match;
}
