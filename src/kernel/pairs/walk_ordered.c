/* SPDX-License-Identifier: BSD-3-Clause */
/* The particles are cut into as many ranges as there are threads. A thread looks through all ledgers for the
 * entries of its range and sorts them by particle (count, scan, fill), then those of each particle by source:
 * no thread waits for another, and none writes where another does. */
#include "kernel/pairs/walk_ordered.h"
#include "base/memory.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* SORT_SHORT: up to so many entries of one particle insertion sort is faster. */
enum { RECORD_MAX = 8, SORT_SHORT = 24 };

/* An entry in the order in which it is to be added. */
struct walk_place {
    struct walk_source source;
    const double *share;
};

/* The room of one range. */
struct walk_range {
    size_t first, last;
    size_t *start; /* of each particle's places; last - first + 1 */
    size_t start_room;
    struct walk_place *place;
    size_t place_room;
};

struct walk_ordered {
    int threads;
    size_t stride; /* doubles that ledgers hold an entry */
    struct walk_ledger **ledger;
    struct walk_range **range; /* each in pages of its own */
};

void walk_ledger_reserve(struct walk_ledger *ledger, size_t entries, size_t stride) {
    if (entries <= ledger->capacity)
        return;
    size_t n = ledger->capacity = entries + entries / 4 + 1024;
    ledger->particle = memory_resize(ledger->particle, n, sizeof *ledger->particle, "shares in order");
    ledger->source = memory_resize(ledger->source, n, sizeof *ledger->source, "shares in order");
    ledger->share = memory_resize(ledger->share, n * stride, sizeof *ledger->share, "shares in order");
}

void walk_ledger_free(struct walk_ledger *ledger) {
    memory_free(ledger->particle);
    memory_free(ledger->source);
    memory_free(ledger->share);
    *ledger = (struct walk_ledger){0};
}

struct walk_ordered *walk_ordered_create(int threads) {
    struct walk_ordered *o = memory_allocate_zero(1, sizeof *o, "shares in order");
    o->threads = threads;
    o->ledger = memory_allocate_zero((size_t)threads, sizeof *o->ledger, "shares in order");
    o->range = memory_allocate_zero((size_t)threads, sizeof *o->range, "shares in order");
    for (int t = 0; t < threads; t++) {
        o->ledger[t] = memory_allocate_zero(1, sizeof *o->ledger[t], "shares in order");
        o->range[t] = memory_allocate_zero(1, sizeof *o->range[t], "shares in order");
    }
    return o;
}

void walk_ordered_destroy(struct walk_ordered **ordered) {
    struct walk_ordered *o = *ordered;
    if (o == NULL)
        return;
    for (int t = 0; t < o->threads; t++) {
        walk_ledger_free(o->ledger[t]);
        memory_free(o->ledger[t]);
        memory_free(o->range[t]->start);
        memory_free(o->range[t]->place);
        memory_free(o->range[t]);
    }
    memory_free(o->ledger);
    memory_free(o->range);
    memory_free(o);
    *ordered = NULL;
}

struct walk_ledger *walk_ordered_ledger(struct walk_ordered *ordered, int thread) {
    return ordered->ledger[thread];
}

static int source_compare(const struct walk_source *a, const struct walk_source *b) {
    if (a->partner != b->partner)
        return a->partner < b->partner ? -1 : 1;
    return a->image < b->image ? -1 : a->image > b->image;
}

static int place_compare(const void *a, const void *b) {
    const struct walk_place *x = a, *y = b;
    return source_compare(&x->source, &y->source);
}

static void places_sort(struct walk_place *place, size_t n) {
    if (n > SORT_SHORT) {
        qsort(place, n, sizeof *place, place_compare);
        return;
    }
    for (size_t k = 1; k < n; k++) {
        struct walk_place one = place[k];
        size_t at = k;
        for (; at > 0 && source_compare(&one.source, &place[at - 1].source) < 0; at--)
            place[at] = place[at - 1];
        place[at] = one;
    }
}

/* Counts the entries of each particle of the range, and turns the counts into starts, one place ahead. */
static void range_count(const struct walk_ordered *o, struct walk_range *range) {
    size_t n = range->last - range->first, sum = 0;
    if (n + 2 > range->start_room) {
        range->start_room = n + n / 8 + 2;
        memory_free(range->start);
        range->start = memory_allocate(range->start_room, sizeof *range->start, "shares in order");
    }
    memset(range->start, 0, (n + 2) * sizeof *range->start);
    for (int t = 0; t < o->threads; t++) {
        const struct walk_ledger *ledger = o->ledger[t];
        for (size_t e = 0; e < ledger->count; e++)
            if (ledger->particle[e] - range->first < n)
                range->start[ledger->particle[e] - range->first + 2]++;
    }
    for (size_t k = 2; k < n + 2; k++)
        range->start[k] = sum += range->start[k];
    if (sum > range->place_room) {
        range->place_room = sum + sum / 8;
        memory_free(range->place);
        range->place = memory_allocate(range->place_room, sizeof *range->place, "shares in order");
    }
}

static void range_fill(const struct walk_ordered *o, struct walk_range *range, size_t stride) {
    size_t n = range->last - range->first;
    for (int t = 0; t < o->threads; t++) {
        const struct walk_ledger *ledger = o->ledger[t];
        for (size_t e = 0; e < ledger->count; e++)
            if (ledger->particle[e] - range->first < n)
                range->place[range->start[ledger->particle[e] - range->first + 1]++] =
                    (struct walk_place){ledger->source[e], ledger->share + e * stride};
    }
}

/* The sums of all particles of the range; forces have a constant stride. */
static inline __attribute__((always_inline)) void range_sum(const struct walk_range *range, double *force,
                                                            const size_t stride) {
    for (size_t i = range->first; i < range->last; i++) {
        size_t first = range->start[i - range->first], n = range->start[i - range->first + 1] - first;
        double sum[RECORD_MAX];
        if (n == 0)
            continue;
        struct walk_place *place = range->place + first;
        places_sort(place, n);
        memcpy(sum, force + i * stride, stride * sizeof *sum);
        for (size_t k = 0; k < n; k++)
            for (size_t c = 0; c < stride; c++)
                sum[c] += place[k].share[c];
        memcpy(force + i * stride, sum, stride * sizeof *sum);
    }
}

static void range_add(const struct walk_ordered *o, struct walk_range *range, double *force, size_t stride) {
    assert(stride <= RECORD_MAX);
    range_count(o, range);
    range_fill(o, range, stride);
    if (stride == 8)
        range_sum(range, force, 8);
    else if (stride == 4)
        range_sum(range, force, 4);
    else
        range_sum(range, force, stride);
}

void walk_ordered_add(struct walk_ordered *o, size_t owned, double *force, size_t stride) {
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < o->threads; t++) {
        o->range[t]->first = owned * (size_t)t / (size_t)o->threads;
        o->range[t]->last = owned * ((size_t)t + 1) / (size_t)o->threads;
        range_add(o, o->range[t], force, stride);
    }
    o->stride = stride;
    walk_ordered_clear(o);
}

void walk_ordered_clear(struct walk_ordered *o) {
    for (int t = 0; t < o->threads; t++)
        o->ledger[t]->count = 0;
}
