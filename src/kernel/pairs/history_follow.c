/* SPDX-License-Identifier: BSD-3-Clause */
/* The possible partners in a hash table, which all threads fill at a time. Several particles may have one id: the
 * original and its copies. */
#include "kernel/pairs/history_keep.h"
#include "base/memory.h"
#include "base/scan.h"
#include "base/hash.h"

struct candidate {
    int64_t id;
    uint32_t number;
};

struct candidates {
    struct candidate *list;
    struct hash by_id;
};

static void candidate_put(struct candidates *all, uint32_t k, const struct particles *particles,
                          uint32_t number) {
    all->list[k] = (struct candidate){particles->id[number], number};
    hash_put(&all->by_id, (uint64_t)all->list[k].id, k);
}

static void candidates_make(struct candidates *all, const struct history_followers *followers,
                            const uint32_t *now) {
    const struct particles *particles = followers->particles;
    size_t near = followers->near_count, count = near + particles->ghosts;
    *all = (struct candidates){.list = memory_allocate(count, sizeof *all->list, "ids of partners")};
    hash_start(&all->by_id, count, "ids of partners");
#pragma omp parallel
    {
#pragma omp for schedule(static) nowait
        for (size_t k = 0; k < near; k++)
            candidate_put(all, (uint32_t)k, particles, history_number(now, followers->near[k]));
#pragma omp for schedule(static)
        for (size_t k = 0; k < particles->ghosts; k++)
            candidate_put(all, (uint32_t)(near + k), particles, (uint32_t)(particles->owned + k));
    }
}

/* Writes the particles with this id unless `match` is NULL; returns how many there are. */
static size_t candidates_find(const struct candidates *all, int64_t id, uint32_t row,
                              struct history_match *match) {
    size_t found = 0;
    for (uint32_t k = hash_first(&all->by_id, (uint64_t)id); k != HASH_END; k = all->by_id.next[k]) {
        if (all->list[k].id != id)
            continue;
        if (match)
            match[found] = (struct history_match){row, all->list[k].number};
        found++;
    }
    return found;
}

struct history_match *history_follow(const struct history_followers *followers, const uint32_t *now,
                                     size_t *count) {
    const struct history_loose *loose = followers->loose;
    struct candidates all;
    candidates_make(&all, followers, now);
    uint32_t *start = memory_allocate(loose->count + 1, sizeof *start, "partners of rows");
#pragma omp parallel for schedule(static)
    for (size_t r = 0; r < loose->count; r++)
        start[r] = (uint32_t)candidates_find(&all, loose->row[r].partner, (uint32_t)r, NULL);
    *count = scan_counts_narrow(start, loose->count, start);
    struct history_match *match = memory_allocate(*count, sizeof *match, "partners of rows");
#pragma omp parallel for schedule(static)
    for (size_t r = 0; r < loose->count; r++)
        candidates_find(&all, loose->row[r].partner, (uint32_t)r, match + start[r]);
    memory_free(start);
    memory_free(all.list);
    hash_free(&all.by_id);
    return match;
}
