/* SPDX-License-Identifier: BSD-3-Clause */
/* Nearly all particles keep their places, so both lists run through memory in nearly the same way, and so do
 * the records. No thread writes data that another thread reads or writes: every thread first turns its own
 * records into pairs of new numbers, and then sorts the records, of any thread, whose lower number lies in
 * its share of the particles. */
#include "kernel/pairs/history_keep.h"
#include "base/memory.h"
#include "base/scan.h"
#include <assert.h>
#include <string.h>

enum { CHUNK = 4096 };

/* Data of history_keep. */
struct keeping {
    const struct history *history;
    const struct pairlist *list;
    const uint32_t *now; /* new number of each old one, or PARTICLE_LEFT; NULL: the old one */
    size_t before;       /* entries of now */
    struct history_kept *kept;
};

/* Links on their way into entries. */
struct sorting {
    struct history_kept *kept;
    size_t threads;
    struct {
        uint32_t lowest, highest;
    } * bounds; /* of the lower numbers of each CHUNK links */
};

/* True if pair k is a second copy: another thread holds the record. */
static bool mirrored(const struct pair_block *mirror, size_t k) {
    return k >= mirror->first_pair && k < mirror->end_pair;
}

/* The number that particle k of the old list has now; copies have none. */
static inline uint32_t number_now(const struct keeping *keeping, uint32_t k) {
    return k >= keeping->before ? PARTICLE_LEFT : keeping->now ? keeping->now[k] : k;
}

/* The records of one thread. */
static void links_make(const struct keeping *keeping, int t) {
    const struct pairlist *list = keeping->list;
    const struct history_part *part = &keeping->history->part[keeping->history->now][t];
    const struct pair_block *mirror = &list->blocks[list->thread_block[t + 1] - 2];
    size_t first = pairlist_thread_first(list, t);
    struct history_link *link = keeping->kept->link + keeping->kept->first[t];
    assert(mirror->kind == PAIR_BLOCK_MIRROR);
    for (size_t r = 0; r < part->count; r++) {
        size_t k = first + part->pair[r];
        link[r].i = number_now(keeping, list->i[k]);
        link[r].j =
            number_now(keeping, pair_partner(list->j[k])) | (mirrored(mirror, k) ? HISTORY_LINK_COPY : 0);
    }
    /* pairs with copies stand behind the mirror block */
    keeping->kept->own[t] = scan_first(part->pair, part->count, mirror->end_pair - first);
}

/* The link as it is sorted: `i` is the lower number, or PARTICLE_LEFT if the record is not kept; HISTORY_KEPT_TURNED is
 * added to `j` as in an entry. */
static inline struct history_link link_sorted(struct history_link link) {
    const bool gone =
        link.i == PARTICLE_LEFT || (link.j & HISTORY_LINK_COPY) != 0; /* or j is PARTICLE_LEFT */
    const bool forward = link.i < link.j;
    return (struct history_link){.i = gone      ? PARTICLE_LEFT
                                      : forward ? link.i
                                                : link.j,
                                 .j = forward ? link.j : link.i | HISTORY_KEPT_TURNED};
}

/* Turns the links of a chunk into those that are sorted, and notes the bounds of their lower numbers. */
static void chunk_turn(const struct sorting *sorting, size_t chunk, size_t last) {
    const struct history_kept *kept = sorting->kept;
    uint32_t lowest = UINT32_MAX, highest = 0;
    for (size_t r = chunk * CHUNK; r < last; r++) {
        kept->link[r] = link_sorted(kept->link[r]);
        uint32_t low = kept->link[r].i;
        lowest = low < lowest ? low : lowest;
        highest = low > highest && low != PARTICLE_LEFT ? low : highest;
    }
    sorting->bounds[chunk].lowest = lowest;
    sorting->bounds[chunk].highest = highest;
}

/* Counts the links of each lower number from begin to end - 1, or (entries given) writes them. The count and the
 * cursor of a number lie one place on; a cursor ends where the links of the next number start. */
static void links_sort(const struct sorting *sorting, uint32_t begin, uint32_t end) {
    struct history_kept *kept = sorting->kept;
    const size_t count = kept->count;
    for (size_t chunk = 0; chunk * CHUNK < count; chunk++) {
        if (sorting->bounds[chunk].highest < begin || sorting->bounds[chunk].lowest >= end)
            continue;
        size_t last = (chunk + 1) * CHUNK < count ? (chunk + 1) * CHUNK : count;
        for (size_t r = chunk * CHUNK; r < last; r++) {
            const struct history_link link = kept->link[r];
            if (link.i < begin || link.i >= end)
                continue;
            uint32_t at = kept->start[link.i + 1]++;
            if (kept->entry)
                kept->entry[at] = (struct history_kept_entry){link.j & ~HISTORY_KEPT_TURNED,
                                                              (uint32_t)r | (link.j & HISTORY_KEPT_TURNED)};
        }
    }
}

static void links_sort_all(const struct sorting *sorting) {
    const size_t owned = sorting->kept->owned, threads = sorting->threads;
#pragma omp parallel for schedule(static, 1)
    for (size_t t = 0; t < threads; t++)
        links_sort(sorting, (uint32_t)(owned * t / threads), (uint32_t)(owned * (t + 1) / threads));
}

/* The new number of each number after the migration; NULL: all keep theirs. */
static uint32_t *numbers_after(const struct history_numbers *numbers) {
    assert(numbers->order || numbers->place == NULL);
    if (numbers->order == NULL)
        return NULL;
    uint32_t *now = memory_allocate(numbers->owned, sizeof *now, "kept history");
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < numbers->owned; k++)
        now[numbers->order[k]] = (uint32_t)k;
    return now;
}

/* The new number of each old one; frees `after`. */
static uint32_t *numbers_before(const struct history_numbers *numbers, uint32_t *after) {
    if (numbers->place == NULL)
        return after;
    uint32_t *all = memory_allocate(numbers->before, sizeof *all, "kept history");
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < numbers->before; k++)
        all[k] = numbers->place[k] != PARTICLE_LEFT ? after[numbers->place[k]] : PARTICLE_LEFT;
    memory_free(after);
    return all;
}

/* The links of the loose rows: their carriers and partners; a row is oriented from the lower id. */
static struct history_link *links_follow(const struct history_followers *followers, const uint32_t *after,
                                         struct history_kept *kept, size_t *count) {
    *count = 0;
    if (followers == NULL)
        return NULL;
    const struct history_loose *loose = followers->loose;
    kept->row = loose->row;
    kept->match = history_follow(followers, after, count);
    struct history_link *link = memory_allocate(*count, sizeof *link, "kept history");
#pragma omp parallel for schedule(static)
    for (size_t m = 0; m < *count; m++) {
        uint32_t row = kept->match[m].row, i = history_number(after, loose->carrier[row]),
                 j = kept->match[m].number;
        bool forward = loose->row[row].id < loose->row[row].partner;
        link[m] = (struct history_link){forward ? i : j, forward ? j : i};
    }
    return link;
}

/* All links: of the records and, behind, of the loose rows. */
static void links_make_all(const struct keeping *keeping, const struct history_link *loose,
                           size_t loose_count) {
    struct history_kept *kept = keeping->kept;
    const size_t records = kept->first[keeping->history->threads];
    kept->count = records + loose_count;
    kept->link = memory_allocate(kept->count, sizeof *kept->link, "kept history");
    if (keeping->list->block_count > 0) {
#pragma omp parallel for schedule(static, 1)
        for (int t = 0; t < keeping->history->threads; t++)
            links_make(keeping, t);
    }
    if (loose_count > 0)
        memcpy(kept->link + records, loose, loose_count * sizeof *loose);
}

void history_kept_sort(struct history_kept *kept, int threads) {
    const size_t owned = kept->owned, chunks = (kept->count + CHUNK - 1) / CHUNK;
    struct sorting sorting = {.kept = kept, .threads = (size_t)threads};
    sorting.bounds = memory_allocate(chunks, sizeof *sorting.bounds, "kept history");
    kept->start = memory_allocate_zero(owned + 2, sizeof *kept->start, "kept history");
    assert(kept->count < HISTORY_KEPT_TURNED);
#pragma omp parallel for schedule(static)
    for (size_t chunk = 0; chunk < chunks; chunk++)
        chunk_turn(&sorting, chunk, (chunk + 1) * CHUNK < kept->count ? (chunk + 1) * CHUNK : kept->count);
    links_sort_all(&sorting);
    size_t count = scan_counts_narrow(kept->start + 1, owned, kept->start + 1);
    kept->entry = memory_allocate(count, sizeof *kept->entry, "kept history");
    links_sort_all(&sorting);
    memory_free(kept->link);
    kept->link = NULL;
    memory_free(sorting.bounds);
}

void history_keep(const struct history *history, const struct pairlist *list,
                  const struct history_numbers *numbers, const struct history_followers *followers,
                  struct history_kept *kept) {
    size_t loose_count;
    *kept = (struct history_kept){.owned = numbers->owned, .owners = pairlist_owners(list)};
    int threads = list->block_count == 0 ? 0 : history->threads;
    for (int t = 0; t < history->threads; t++)
        kept->first[t + 1] = kept->first[t] + (t < threads ? history->part[history->now][t].count : 0);
    uint32_t *now = numbers_after(numbers);
    struct history_link *loose = links_follow(followers, now, kept, &loose_count);
    now = numbers_before(numbers, now);
    struct keeping keeping = {
        .history = history, .list = list, .now = now, .before = numbers->before, .kept = kept};
    links_make_all(&keeping, loose, loose_count);
    if (now)
        history_kept_sort(kept, history->threads);
    memory_free(loose);
    memory_free(now);
}

void history_kept_free(struct history_kept *kept) {
    memory_free(kept->start);
    memory_free(kept->entry);
    memory_free(kept->match);
    memory_free(kept->link);
    *kept = (struct history_kept){0};
}
