/* SPDX-License-Identifier: BSD-3-Clause */
/* Nearly all particles keep their places, so both lists run through memory in nearly the same way, and so do
 * the records. No thread writes data that another thread reads or writes: every thread first turns its own
 * records into pairs of new numbers, and then sorts the records, of any thread, whose lower number lies in
 * its share of the particles.
 *
 * Where all particles keep their numbers, both lists have the pairs with records in the same order as a rule. Each
 * thread then meets its records one after another in the new list, and only notes the new numbers of the pairs: no
 * value moves, and nothing is sorted. If a thread ends with records that it has not met, all go the other way, and so they do
 * if the threads' rows or the classes with slots are others than before: then a pair may need a second record, or one less. */
#include "kernel/pairs/history_keep.h"
#include "base/memory.h"
#include "base/scan.h"
#include <assert.h>
#include <string.h>

enum { CHUNK = 4096, BATCH = 1024 };

/* Data of history_keep. */
struct keeping {
    const struct history *history;
    const struct pairlist *list;
    const uint32_t *now; /* new number of each old one, or PARTICLE_LEFT; NULL: the old one */
    size_t before;       /* entries of now */
    struct history_kept *kept;
    struct history_link *link; /* of each record and loose row */
    size_t count;
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
    struct history_link *link = keeping->link + keeping->kept->first[t];
    assert(mirror->kind == PAIR_BLOCK_MIRROR);
    for (size_t r = 0; r < part->count; r++) {
        size_t k = first + part->pair[r];
        link[r].i = number_now(keeping, list->i[k]);
        link[r].j =
            number_now(keeping, pair_partner(list->j[k])) | (mirrored(mirror, k) ? HISTORY_LINK_COPY : 0);
    }
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
static void chunk_turn(const struct keeping *keeping, size_t chunk, size_t last) {
    uint32_t lowest = UINT32_MAX, highest = 0;
    for (size_t r = chunk * CHUNK; r < last; r++) {
        keeping->link[r] = link_sorted(keeping->link[r]);
        uint32_t low = keeping->link[r].i;
        lowest = low < lowest ? low : lowest;
        highest = low > highest && low != PARTICLE_LEFT ? low : highest;
    }
    keeping->bounds[chunk].lowest = lowest;
    keeping->bounds[chunk].highest = highest;
}

/* Counts the links of each lower number from begin to end - 1, or (entries given) writes them. The count and the
 * cursor of a number lie one place on; a cursor ends where the links of the next number start. */
static void links_sort(const struct keeping *keeping, uint32_t begin, uint32_t end) {
    struct history_kept *kept = keeping->kept;
    size_t count = keeping->count;
    for (size_t chunk = 0; chunk * CHUNK < count; chunk++) {
        if (keeping->bounds[chunk].highest < begin || keeping->bounds[chunk].lowest >= end)
            continue;
        size_t last = (chunk + 1) * CHUNK < count ? (chunk + 1) * CHUNK : count;
        for (size_t r = chunk * CHUNK; r < last; r++) {
            const struct history_link link = keeping->link[r];
            if (link.i < begin || link.i >= end)
                continue;
            uint32_t at = kept->start[link.i + 1]++;
            if (kept->entry)
                kept->entry[at] = (struct history_kept_entry){link.j & ~HISTORY_KEPT_TURNED,
                                                              (uint32_t)r | (link.j & HISTORY_KEPT_TURNED)};
        }
    }
}

static void links_sort_all(const struct keeping *keeping) {
    size_t owned = keeping->kept->owned, threads = (size_t)keeping->history->threads;
#pragma omp parallel for schedule(static, 1)
    for (size_t t = 0; t < threads; t++)
        links_sort(keeping, (uint32_t)(owned * t / threads), (uint32_t)(owned * (t + 1) / threads));
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
static void links_make_all(struct keeping *keeping, const struct history_link *loose, size_t loose_count) {
    const size_t records = keeping->kept->first[keeping->history->threads];
    keeping->count = records + loose_count;
    keeping->link = memory_allocate(keeping->count, sizeof *keeping->link, "kept history");
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < keeping->history->threads; t++)
        links_make(keeping, t);
    if (loose_count > 0)
        memcpy(keeping->link + records, loose, loose_count * sizeof *loose);
}

/* Makes the entries from the links, which are freed. */
static void entries_make(struct keeping *keeping) {
    struct history_kept *kept = keeping->kept;
    const size_t owned = kept->owned, chunks = (keeping->count + CHUNK - 1) / CHUNK;
    keeping->bounds = memory_allocate(chunks, sizeof *keeping->bounds, "kept history");
    kept->start = memory_allocate_zero(owned + 2, sizeof *kept->start, "kept history");
    assert(keeping->count < HISTORY_KEPT_TURNED);
#pragma omp parallel for schedule(static)
    for (size_t chunk = 0; chunk < chunks; chunk++)
        chunk_turn(keeping, chunk,
                   (chunk + 1) * CHUNK < keeping->count ? (chunk + 1) * CHUNK : keeping->count);
    links_sort_all(keeping);
    size_t count = scan_counts_narrow(kept->start + 1, owned, kept->start + 1);
    kept->entry = memory_allocate(count, sizeof *kept->entry, "kept history");
    links_sort_all(keeping);
    memory_free(keeping->link);
    memory_free(keeping->bounds);
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
    if (now == NULL && followers == NULL)
        kept->link = keeping.link;
    else
        entries_make(&keeping);
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

/* The record of a pair as seen from i, or PARTICLE_LEFT: the first one, if both ends came with a row. The lower
 * number is never that of a copy. No branch depends on whether there is a record, as the CPU could not predict
 * it. */
static inline uint32_t record_of(const struct history_kept *kept, uint32_t i, uint32_t j) {
    uint32_t low = i < j ? i : j, high = i < j ? j : i, record = 0, hits = 0, end = kept->start[low + 1];
    for (uint32_t e = kept->start[low]; e < end; e++) {
        uint32_t hit = (kept->entry[e].partner == high) & ~hits;
        record |= kept->entry[e].record & (0 - hit);
        hits |= hit;
    }
    record ^= (uint32_t)(i > j) << 31;
    return record | (hits - 1);
}

/* Data of history_restore. */
struct restoring {
    const struct history_kept *kept;
    const struct history_twins *twins;
    const struct pairlist *list;
};

static bool is_twin(const struct history_twins *twins, uint32_t k) {
    return k >= twins->first && k - twins->first < twins->count;
}

/* The owned particle of which k is a copy; any other k is returned itself. */
static uint32_t original_of(const struct history_twins *twins, uint32_t k) {
    return is_twin(twins, k) ? twins->original[k - twins->first] : k;
}

/* True if a pair may have a record: few have, and most of the others are known by the lower number alone. */
static inline bool may_have_record(const struct history_kept *kept, uint32_t i, uint32_t j) {
    uint32_t low = i < j ? i : j;
    return kept->start[low] != kept->start[low + 1];
}

/* Chooses the pairs of [first, last) that may have a history, counted from the first; returns their
 * number. */
static inline size_t pairs_choose(const struct restoring *r, size_t first, size_t last, bool twins,
                                  uint32_t *restrict chosen) {
    size_t count = 0;
    for (size_t k = first; k < last; k++) {
        uint32_t i = r->list->i[k], j = pair_partner(r->list->j[k]);
        chosen[count] = (uint32_t)(k - first);
        count += may_have_record(r->kept, i, j) || (twins && is_twin(r->twins, i < j ? j : i));
    }
    return count;
}

/* The value of pair k and its sign; NULL: there is none. */
static const double *pair_value(const struct history *history, const struct restoring *r, size_t k,
                                double *sign) {
    uint32_t i = r->list->i[k], j = pair_partner(r->list->j[k]);
    uint32_t record = record_of(r->kept, i, j);
    if (record == PARTICLE_LEFT && r->twins->count == 0)
        return NULL;
    if (record == PARTICLE_LEFT) { /* one of the two may be a copy of a particle of this rank */
        uint32_t own_i = original_of(r->twins, i), own_j = original_of(r->twins, j);
        if (own_i != i || own_j != j)
            record = record_of(r->kept, own_i, own_j);
    }
    if (record == PARTICLE_LEFT)
        return NULL;
    *sign = record & HISTORY_KEPT_TURNED ? -1 : 1;
    record &= ~HISTORY_KEPT_TURNED;
    int t = 0;
    while (t < history->threads && record >= r->kept->first[t + 1])
        t++;
    if (t == history->threads)
        return r->kept->row[r->kept->match[record - r->kept->first[t]].row].value;
    return history->part[history->now][t].value + (record - r->kept->first[t]) * (size_t)history->components;
}

/* Finds the records of the pairs of one thread and writes them to the buffer that is not read. */
static void restore_thread(struct history *history, const struct restoring *r, int t) {
    const struct pairlist *list = r->list;
    size_t components = (size_t)history->components, first = pairlist_thread_first(list, t), count = 0;
    struct history_part *part = &history->part[1 - history->now][t];
    uint32_t chosen[BATCH];
    for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++) {
        size_t end = list->blocks[b].end_pair;
        for (size_t k = list->blocks[b].first_pair; k < end; k += BATCH) {
            size_t last = k + BATCH < end ? k + BATCH : end;
            size_t found = r->twins->count > 0 ? pairs_choose(r, k, last, true, chosen)
                                               : pairs_choose(r, k, last, false, chosen);
            history_reserve(history, t, count + found);
            for (size_t f = 0; f < found; f++) {
                double sign;
                const double *value = pair_value(history, r, k + chosen[f], &sign);
                if (value == NULL)
                    continue;
                part->pair[count] = (uint32_t)(k + chosen[f] - first);
                for (size_t c = 0; c < components; c++)
                    part->value[count * components + c] = (c < (size_t)history->odd ? sign : 1) * value[c];
                count++;
            }
        }
    }
    part->count = count;
}

/* True if pair k of the list is that of the link. */
static inline bool is_pair(const struct pairlist *list, size_t k, struct history_link link) {
    return list->i[k] == link.i && pair_partner(list->j[k]) == (link.j & ~HISTORY_LINK_COPY);
}

/* Gives the records of one thread the new numbers of their pairs, if the thread meets all of them in their order.
 * Few pairs come or go between two records, so a pair mostly lies as far from its old number as the one before. */
static bool renumber_thread(struct history *history, const struct restoring *r, int t) {
    const struct pairlist *list = r->list;
    const struct history_link *link = r->kept->link + r->kept->first[t];
    struct history_part *part = &history->part[history->now][t];
    const size_t first = pairlist_thread_first(list, t), records = r->kept->first[t + 1] - r->kept->first[t];
    const size_t end = records > 0 ? list->blocks[list->thread_block[t + 1] - 1].end_pair : first;
    size_t next = first, moved = 0; /* modulo 2^64: numbers may fall, too */
    part->count = records;
    for (size_t m = 0; m < records; m++) {
        size_t k = first + part->pair[m] + moved;
        if (k < next || k >= end || !is_pair(list, k, link[m])) {
            for (k = next; k < end && !is_pair(list, k, link[m]); k++)
                ;
            if (k == end)
                return false;
            moved = k - first - part->pair[m];
        }
        part->pair[m] = (uint32_t)(k - first);
        next = k + 1;
    }
    return true;
}

static bool renumber(struct history *history, const struct restoring *restoring) {
    bool all = true;
    assert(restoring->list->threads == history->threads);
#pragma omp parallel for schedule(static, 1) reduction(&& : all)
    for (int t = 0; t < history->threads; t++)
        all = all && renumber_thread(history, restoring, t);
    return all;
}

void history_restore(struct history *history, struct history_kept *kept, const struct history_twins *twins,
                     const struct pairlist *list) {
    struct restoring restoring = {kept, twins, list};
    if (kept->link) {
        if (kept->owners == pairlist_owners(list) && renumber(history, &restoring))
            return;
        struct keeping keeping = {
            .history = history, .kept = kept, .link = kept->link, .count = kept->first[history->threads]};
        kept->link = NULL;
        entries_make(&keeping);
    }
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < history->threads; t++)
        restore_thread(history, &restoring, t);
    history_flip(history);
}
