/* SPDX-License-Identifier: BSD-3-Clause */
/* Pairs of unlike levels, found from the larger side. Read cross.h first. */
#include "index/grids/cross.h"

#include "core/memory.h"

#include <omp.h>

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

/* Counts the partners of the rows [first, last) into end[]; returns their sum. */
static size_t count_rows(struct cross_pairs *cross, size_t first, size_t last) {
    size_t sum = 0;
    for (size_t row = first; row < last; row++) {
        cross->end[row] = 0;
    }
    for (int t = 0; t < cross->threads; t++) {
        const struct index_sink *found = &cross->found[t];
        for (size_t k = 0; k < found->count; k++) {
            size_t row = found->j[k] & particle_mask;
            if (row - first < last - first) {
                cross->end[row]++;
                sum++;
            }
        }
    }
    return sum;
}

/* Turns the counts of the rows into places from `at` on and puts their partners there. */
static void fill_rows(struct cross_pairs *cross, size_t first, size_t last, size_t at) {
    const size_t begin = at;
    for (size_t row = first; row < last; row++) {
        size_t count = cross->end[row];
        cross->end[row] = (uint32_t)at;
        at += count;
    }
    for (int t = 0; t < cross->threads; t++) {
        const struct index_sink *found = &cross->found[t];
        for (size_t k = 0; k < found->count; k++) {
            size_t row = found->j[k] & particle_mask;
            if (row - first < last - first) {
                unsigned code = image_opposite(found->j[k] >> INDEX_IMAGE_SHIFT);
                cross->partner[cross->end[row]++] = found->i[k] | code << INDEX_IMAGE_SHIFT;
            }
        }
    }
    for (size_t row = first, from = begin; row < last; from = cross->end[row++]) {
        partners_sort(cross->partner + from, cross->end[row] - from);
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

void cross_find(struct cross_pairs *cross, const struct cross_finder *finder, const struct index_view *view) {
    cross->rows = view->owned;
    reserve(cross, view);
    size_t *begin = memory_allocate_zero((size_t)view->threads + 1, sizeof *begin, "pairs of levels");
#pragma omp parallel num_threads(view->threads)
    {
        size_t threads = (size_t)omp_get_num_threads(), t = (size_t)omp_get_thread_num();
        size_t first = view->owned * t / threads, last = view->owned * (t + 1) / threads;
        find_share(finder, view, &cross->found[t]);
        begin[t + 1] = count_rows(cross, first, last);
#pragma omp barrier
#pragma omp single
        {
            for (size_t k = 0; k < threads; k++) {
                begin[k + 1] += begin[k];
            }
            reserve_partners(cross, begin[threads]);
        }
        fill_rows(cross, first, last, begin[t]);
    }
    memory_free(begin);
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
    memory_free(cross->end);
    memory_free(cross->partner);
    *cross = (struct cross_pairs){0};
}

size_t cross_memory(const struct cross_pairs *cross) {
    size_t entries = cross->row_capacity + cross->partner_capacity;
    for (int t = 0; t < cross->threads; t++) {
        entries += 2 * cross->found[t].capacity;
    }
    return entries * sizeof(uint32_t);
}
