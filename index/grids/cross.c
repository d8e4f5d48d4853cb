/* SPDX-License-Identifier: BSD-3-Clause */
/* Pairs of unlike levels, found from the larger side. Read cross.h first. */
#include "index/grids/cross.h"

#include "base/memory.h"

#include <omp.h>
#include <string.h>

enum { CHUNK = 32, CHUNKS_A_THREAD = 8, FOUND_FIRST = 1 << 12 };

static const uint32_t particle_mask = ((uint32_t)1 << INDEX_IMAGE_SHIFT) - 1;

static void sink_reserve(struct index_sink *sink, size_t count) {
    if (count > sink->capacity) {
        sink->capacity = count + count / 2 + FOUND_FIRST;
        sink->i = memory_resize(sink->i, sink->capacity + INDEX_SINK_PAD, sizeof *sink->i, "pairs of levels");
        sink->j = memory_resize(sink->j, sink->capacity + INDEX_SINK_PAD, sizeof *sink->j, "pairs of levels");
    }
}

static void find_rows(const struct cross_finder *finder, const struct index_view *view, size_t first,
                      size_t last, struct index_sink *sink) {
    size_t before = sink->count;
    finder->find(finder->context, view, first, last, sink);
    if (sink->count > sink->capacity) {
        sink_reserve(sink, sink->count);
        sink->count = before;
        finder->find(finder->context, view, first, last, sink);
    }
}

/* The share of one thread of a team in the search for pairs. */
static void find_share(const struct cross_finder *finder, const struct index_view *view,
                       struct index_sink *sink) {
    const struct members *owned = finder->owned;
    const size_t first = finder->first;
    const size_t share = (view->owned - first) / (CHUNKS_A_THREAD * (size_t)omp_get_num_threads());
    const size_t chunk = share < 1 ? 1 : share < CHUNK ? share : CHUNK;
#pragma omp for schedule(dynamic, 1)
    for (size_t begin = first; begin < view->owned; begin += chunk) {
        size_t end = begin + chunk < view->owned ? begin + chunk : view->owned;
        if (owned->contiguous) {
            find_rows(finder, view, owned->first + begin, owned->first + end, sink);
            continue;
        }
        for (size_t k = begin; k < end; k++) {
            find_rows(finder, view, owned->list[k], owned->list[k] + 1, sink);
        }
    }
}

static void partners_sort(uint32_t *partner, size_t count) {
    for (size_t k = 1; k < count; k++) {
        uint32_t value = partner[k];
        size_t at = k;
        for (; at > 0 && partner[at - 1] > value; at--) {
            partner[at] = partner[at - 1];
        }
        partner[at] = value;
    }
}

/* The rows of each of `threads` threads: [bound[t], bound[t + 1]). */
struct owners {
    size_t threads;
    const size_t *bound;
    double scale; /* threads / rows */
};

static size_t owner_of(const struct owners *owners, size_t row) {
    size_t t = (size_t)((double)row * owners->scale);
    t = t < owners->threads ? t : owners->threads - 1;
    while (row < owners->bound[t]) {
        t--;
    }
    while (row >= owners->bound[t + 1]) {
        t++;
    }
    return t;
}

/* Sorts the finds of thread t by the threads that own their rows, so that no thread looks through the finds of
 * all: counts of each owner first. */
static void count_owners(struct cross_pairs *cross, const struct owners *owners, size_t t) {
    const struct index_sink *found = &cross->found[t];
    size_t threads = owners->threads, *count = cross->place + t * (threads + 1);
    memset(count, 0, (threads + 1) * sizeof *count);
    for (size_t k = 0; k < found->count; k++) {
        count[owner_of(owners, found->j[k] & particle_mask)]++;
    }
}

/* Then their places: those of an owner lie together, in the order of the threads that found them. Leaves the
 * first place of each owner in place[threads] of its own row. One thread. */
static void place_owners(struct cross_pairs *cross, size_t threads) {
    size_t at = 0;
    for (size_t owner = 0; owner < threads; owner++) {
        cross->place[owner * (threads + 1) + threads] = at;
        for (size_t t = 0; t < threads; t++) {
            size_t *place = &cross->place[t * (threads + 1) + owner];
            size_t count = *place;
            *place = at;
            at += count;
        }
    }
}

static void put_owners(struct cross_pairs *cross, const struct owners *owners, size_t t) {
    const struct index_sink *found = &cross->found[t];
    size_t *place = cross->place + t * (owners->threads + 1);
    for (size_t k = 0; k < found->count; k++) {
        size_t at = place[owner_of(owners, found->j[k] & particle_mask)]++;
        cross->sorted.i[at] = found->i[k];
        cross->sorted.j[at] = found->j[k];
    }
}

/* Sorts the finds of an owner, [begin, end) of `from`, by rows [first, last) and their partners. */
static void fill_rows(struct cross_pairs *cross, const struct index_sink *from, size_t begin, size_t end,
                      size_t first, size_t last) {
    memset(cross->end + first, 0, (last - first) * sizeof *cross->end);
    for (size_t k = begin; k < end; k++) {
        cross->end[from->j[k] & particle_mask]++;
    }
    size_t at = begin;
    for (size_t row = first; row < last; row++) {
        size_t count = cross->end[row];
        cross->end[row] = (uint32_t)at;
        at += count;
    }
    for (size_t k = begin; k < end; k++) {
        unsigned code = image_opposite(from->j[k] >> INDEX_IMAGE_SHIFT);
        cross->partner[cross->end[from->j[k] & particle_mask]++] = from->i[k] | code << INDEX_IMAGE_SHIFT;
    }
    for (size_t row = first, start = begin; begin < end && row < last; start = cross->end[row++]) {
        partners_sort(cross->partner + start, cross->end[row] - start);
    }
}

/* Makes room for the rows and for the pairs of all threads, and sets the numbers of pairs to 0. */
static void reserve(struct cross_pairs *cross, const struct index_view *view) {
    if (view->threads > cross->threads) {
        cross->found =
            memory_resize(cross->found, (size_t)view->threads, sizeof *cross->found, "pairs of levels");
        for (; cross->threads < view->threads; cross->threads++) {
            cross->found[cross->threads] = (struct index_sink){0};
            sink_reserve(&cross->found[cross->threads], FOUND_FIRST);
        }
    }
    for (int t = 0; t < cross->threads; t++) {
        cross->found[t].count = 0;
    }
    size_t places = (size_t)view->threads * ((size_t)view->threads + 1);
    if (places > cross->place_capacity) {
        cross->place_capacity = places;
        memory_free(cross->place);
        cross->place = memory_allocate(places, sizeof *cross->place, "pairs of levels");
    }
    if (view->owned > cross->row_capacity) {
        cross->row_capacity = view->owned + view->owned / 8;
        memory_free(cross->end);
        cross->end = memory_allocate(cross->row_capacity, sizeof *cross->end, "pairs of levels");
    }
}

static void reserve_partners(struct cross_pairs *cross, size_t count) {
    if (count > UINT32_MAX) {
        error_fatal(
            "%zu pairs of particles on different levels on one rank: more than 2^32 - 1; take more ranks",
            count);
    }
    if (count > cross->partner_capacity) {
        cross->partner_capacity = count + count / 8 + FOUND_FIRST;
        memory_free(cross->partner);
        cross->partner = memory_allocate(cross->partner_capacity, sizeof *cross->partner, "pairs of levels");
    }
}

void cross_clear(struct cross_pairs *cross) {
    cross->rows = 0;
}

/* The finds of all threads, counted and placed by owners; makes room for the pairs. One thread. */
static void settle(struct cross_pairs *cross, size_t threads) {
    size_t count = 0;
    for (size_t t = 0; t < threads; t++) {
        count += cross->found[t].count;
    }
    reserve_partners(cross, count);
    if (threads > 1) {
        place_owners(cross, threads);
        cross->sorted.count = count;
        sink_reserve(&cross->sorted, count);
    }
}

/* The thread's part of the sorting by rows. All threads of a team. */
static void share_sort(struct cross_pairs *cross, const struct owners *owners, size_t t) {
    size_t threads = owners->threads, first = owners->bound[t], last = owners->bound[t + 1];
    if (threads > 1) {
        count_owners(cross, owners, t);
#pragma omp barrier
    }
#pragma omp single
    settle(cross, threads);
    if (threads == 1) {
        fill_rows(cross, &cross->found[0], 0, cross->found[0].count, first, last);
        return;
    }
    put_owners(cross, owners, t);
#pragma omp barrier
    const size_t *start = cross->place + threads;
    size_t end = t + 1 < threads ? start[(t + 1) * (threads + 1)] : cross->sorted.count;
    fill_rows(cross, &cross->sorted, start[t * (threads + 1)], end, first, last);
}

void cross_find(struct cross_pairs *cross, const struct cross_finder *finder, const struct index_view *view) {
    cross->rows = view->owned;
    reserve(cross, view);
    size_t *bound = memory_allocate((size_t)view->threads + 1, sizeof *bound, "pairs of levels");
#pragma omp parallel num_threads(view->threads)
    {
        size_t threads = (size_t)omp_get_num_threads(), t = (size_t)omp_get_thread_num();
        struct owners owners = {threads, bound, (double)threads / (double)(view->owned + 1)};
        bound[t] = view->owned * t / threads;
        if (t == 0) {
            bound[threads] = view->owned;
        }
        find_share(finder, view, &cross->found[t]);
        share_sort(cross, &owners, t);
    }
    memory_free(bound);
}

void cross_visit(const struct cross_pairs *cross, size_t first, size_t last, struct index_sink *sink) {
    if (cross->rows == 0 || first >= last) {
        return;
    }
    size_t k = first > 0 ? cross->end[first - 1] : 0;
    for (size_t row = first; row < last; row++) {
        for (; k < cross->end[row]; k++) {
            index_sink_put(sink, (uint32_t)row, cross->partner[k] & particle_mask,
                           cross->partner[k] >> INDEX_IMAGE_SHIFT);
        }
    }
}

void cross_free(struct cross_pairs *cross) {
    for (int t = 0; t < cross->threads; t++) {
        memory_free(cross->found[t].i);
        memory_free(cross->found[t].j);
    }
    memory_free(cross->found);
    memory_free(cross->sorted.i);
    memory_free(cross->sorted.j);
    memory_free(cross->place);
    memory_free(cross->end);
    memory_free(cross->partner);
    *cross = (struct cross_pairs){0};
}

size_t cross_memory(const struct cross_pairs *cross) {
    size_t entries = cross->row_capacity + cross->partner_capacity + 2 * cross->sorted.capacity;
    for (int t = 0; t < cross->threads; t++) {
        entries += 2 * cross->found[t].capacity;
    }
    return entries * sizeof(uint32_t) + cross->place_capacity * sizeof *cross->place;
}
