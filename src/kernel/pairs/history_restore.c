/* SPDX-License-Identifier: BSD-3-Clause */
/* Records find the pairs of the new list. Where all particles keep their numbers, both lists have the pairs with records in the
 * same order as a rule. Each thread then meets its records one after another in the new list, and only notes the new numbers of
 * the pairs: no value moves, and nothing is sorted; the loose rows, which are those of pairs with copies, follow behind. If a thread
 * ends with records that it has not met, all go the other way, and so they do if the threads' rows or the classes with slots are
 * others than before: then a pair may need a second record, or one less. */
#include "kernel/pairs/history_keep.h"
#include <assert.h>
#include <string.h>

enum { BATCH = 1024 };

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

/* Finds the records of the pairs of blocks [first, last) of thread t and adds them to `part`. */
static void restore_blocks(const struct history *history, const struct restoring *r, int t, int first,
                           int last, struct history_part *part) {
    const struct pairlist *list = r->list;
    const size_t components = (size_t)history->components, first_pair = pairlist_thread_first(list, t);
    uint32_t chosen[BATCH];
    for (int b = first; b < last; b++) {
        size_t end = list->blocks[b].end_pair;
        for (size_t k = list->blocks[b].first_pair; k < end; k += BATCH) {
            size_t stop = k + BATCH < end ? k + BATCH : end;
            size_t found = r->twins->count > 0 ? pairs_choose(r, k, stop, true, chosen)
                                               : pairs_choose(r, k, stop, false, chosen);
            history_part_reserve(part, history->components, part->count + found);
            for (size_t f = 0; f < found; f++) {
                double sign;
                const double *value = pair_value(history, r, k + chosen[f], &sign);
                if (value == NULL)
                    continue;
                part->pair[part->count] = (uint32_t)(k + chosen[f] - first_pair);
                for (size_t c = 0; c < components; c++)
                    part->value[part->count * components + c] =
                        (c < (size_t)history->odd ? sign : 1) * value[c];
                part->count++;
            }
        }
    }
}

/* True if pair k of the list is that of the link. */
static inline bool is_pair(const struct pairlist *list, size_t k, struct history_link link) {
    return list->i[k] == link.i && pair_partner(list->j[k]) == (link.j & ~HISTORY_LINK_COPY);
}

/* Gives the records of one thread, but those of pairs with copies, the new numbers of their pairs, if the thread meets all of
 * them in their order. Few pairs come or go between two records, so a pair mostly lies as far from its old number as the one
 * before. The records of pairs with copies are then no more in the part. */
static bool renumber_thread(struct history *history, const struct restoring *r, int t) {
    const struct pairlist *list = r->list;
    const struct history_link *link = r->kept->link + r->kept->first[t];
    struct history_part *part = &history->part[history->now][t];
    const size_t first = pairlist_thread_first(list, t), records = r->kept->own[t];
    const size_t end = records > 0 ? list->blocks[list->thread_block[t + 1] - 1].first_pair : first;
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

/* Forgets the records, which have found their pairs; only the loose rows are left. */
static void records_forget(struct history_kept *kept, int threads) {
    const size_t records = kept->first[threads];
    kept->count -= records;
    memmove(kept->link, kept->link + records, kept->count * sizeof *kept->link);
    memset(kept->first, 0, sizeof kept->first);
}

/* Adds the loose rows behind the records that have stayed in place. */
static void restore_loose(struct history *history, const struct restoring *r) {
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < history->threads; t++) {
        const int end = r->list->thread_block[t + 1];
        restore_blocks(history, r, t, end - 1, end, &history->part[history->now][t]);
    }
}

void history_restore(struct history *history, struct history_kept *kept, const struct history_twins *twins,
                     const struct pairlist *list) {
    struct restoring restoring = {kept, twins, list};
    const bool in_place = kept->link && twins->count == 0 && kept->owners == pairlist_owners(list) &&
                          renumber(history, &restoring);
    if (in_place)
        records_forget(kept, history->threads);
    if (in_place && kept->count == 0)
        return;
    if (kept->link)
        history_kept_sort(kept, history->threads);
    if (in_place) {
        restore_loose(history, &restoring);
        return;
    }
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < history->threads; t++) {
        struct history_part *part = &history->part[1 - history->now][t];
        part->count = 0;
        restore_blocks(history, &restoring, t, list->thread_block[t], list->thread_block[t + 1], part);
    }
    history_flip(history);
}
