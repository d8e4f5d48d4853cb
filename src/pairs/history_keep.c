#include "pairs/history_keep.h"
#include "core/memory.h"
#include "core/scan.h"
#include <assert.h>
#include <string.h>

/* Is pair k a second copy, of a record that another thread holds? */
static bool mirrored(const struct pair_block *mirror, size_t k) {
    return k >= mirror->first_pair && k < mirror->end_pair;
}

/* One bit of 64, by the partner's number. */
static inline uint64_t partner_bit(uint32_t partner) {
    return (uint64_t)1 << (partner * 2654435769u >> 26);
}

/* Counts the records of each row of a thread, or (entries given) writes them, moving the starts on. */
static void records_put(const struct history *history, const struct pairlist *list, int t,
                        struct history_kept *kept) {
    const struct history_part *part = &history->part[history->now][t];
    const struct pair_block *mirror = &list->blocks[list->thread_block[t + 1] - 2];
    size_t first = pairlist_thread_first(list, t);
    assert(mirror->kind == PAIR_BLOCK_MIRROR);
    for (size_t r = 0; r < part->count; r++) {
        size_t k = first + part->pair[r];
        if (mirrored(mirror, k))
            continue;
        uint32_t row = list->i[k], partner = pair_partner(list->j[k]), at = kept->start[row]++;
        if (kept->entry)
            kept->entry[at] = (struct history_kept_entry){partner, (uint32_t)(kept->first[t] + r)};
        else
            kept->mask[row] |= partner_bit(partner);
    }
}

void history_keep(const struct history *history, const struct pairlist *list, size_t owned,
                  struct history_kept *kept) {
    *kept = (struct history_kept){.owned = owned};
    kept->start = memory_allocate_zero(owned + 1, sizeof *kept->start, "kept history");
    kept->mask = memory_allocate_zero(owned, sizeof *kept->mask, "kept history");
    if (list->block_count == 0)
        return;
    for (int t = 0; t < history->threads; t++)
        kept->first[t + 1] = kept->first[t] + history->part[history->now][t].count;
    assert(kept->first[history->threads] <= UINT32_MAX);
#pragma omp parallel for num_threads(history->threads) schedule(static, 1)
    for (int t = 0; t < history->threads; t++)
        records_put(history, list, t, kept);
    size_t count = scan_counts_narrow(kept->start, owned, kept->start);
    kept->entry = memory_allocate(count, sizeof *kept->entry, "kept history");
#pragma omp parallel for num_threads(history->threads) schedule(static, 1)
    for (int t = 0; t < history->threads; t++)
        records_put(history, list, t, kept);
    /* Each start has moved on to the next one's */
    memmove(kept->start + 1, kept->start, owned * sizeof *kept->start);
    kept->start[0] = 0;
}

void history_kept_free(struct history_kept *kept) {
    memory_free(kept->start);
    memory_free(kept->mask);
    memory_free(kept->entry);
    *kept = (struct history_kept){0};
}

/* The record of the pair of old numbers (row, partner), or UINT32_MAX. */
static inline uint32_t record_find(const struct history_kept *kept, uint32_t row, uint32_t partner) {
    if (!(kept->mask[row] & partner_bit(partner)))
        return UINT32_MAX;
    for (uint32_t k = kept->start[row]; k < kept->start[row + 1]; k++)
        if (kept->entry[k].partner == partner)
            return kept->entry[k].record;
    return UINT32_MAX;
}

static const double *record_value(const struct history *history, const struct history_kept *kept,
                                  uint32_t record) {
    int t = 0;
    while (record >= kept->first[t + 1])
        t++;
    return history->part[history->now][t].value + (record - kept->first[t]) * (size_t)history->components;
}

/* The pairs of one thread find their records; they go to the buffer that is not read. */
static void restore_thread(struct history *history, const struct history_kept *kept, const uint32_t *order,
                           const struct pairlist *list, int t) {
    size_t components = (size_t)history->components, first = pairlist_thread_first(list, t), count = 0;
    struct history_part *part = &history->part[1 - history->now][t];
    for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++) {
        size_t last = list->blocks[b].end_pair;
        history_reserve(history, t, count + last - list->blocks[b].first_pair);
        for (size_t k = list->blocks[b].first_pair; k < last; k++) {
            uint32_t i = order[list->i[k]], j = order[pair_partner(list->j[k])];
            double sign = 1;
            uint32_t record = record_find(kept, i, j);
            if (record == UINT32_MAX) {
                record = record_find(kept, j, i);
                sign = -1;
            }
            if (record == UINT32_MAX)
                continue;
            const double *value = record_value(history, kept, record);
            part->pair[count] = (uint32_t)(k - first);
            for (size_t c = 0; c < components; c++)
                part->value[count * components + c] = sign * value[c];
            count++;
        }
    }
    part->count = count;
}

void history_restore(struct history *history, const struct history_kept *kept, const uint32_t *order,
                     const struct pairlist *list) {
#pragma omp parallel for num_threads(history->threads) schedule(static, 1)
    for (int t = 0; t < history->threads; t++)
        restore_thread(history, kept, order, list, t);
    history_flip(history);
}
