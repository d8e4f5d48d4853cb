/* SPDX-License-Identifier: BSD-3-Clause */
/* From the pair list to coloured pairs with a memory, and back into rows. Read pairs.h first. */
#include "physics/hard/pairs.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

static const char what[] = "pairs of contacts";

void hard_pairs_create(struct hard_pairs *pairs, int threads, bool resists) {
    int components = resists ? HARD_MEMORY_RESISTS : HARD_MEMORY;
    *pairs = (struct hard_pairs){.history = history_create(components, threads), .resists = resists};
    pairs->history->odd = resists ? HARD_MEMORY_RESISTS_ODD : HARD_MEMORY_ODD;
}

static void arrays_free(struct hard_pairs *pairs) {
    hard_colours_free(&pairs->colours);
    memory_free(pairs->end);
    memory_free(pairs->image);
    memory_free(pairs->number);
    memory_free(pairs->memory);
    memory_free(pairs->couple);
    pairs->end = NULL;
    pairs->image = NULL;
    pairs->number = NULL;
    pairs->memory = NULL;
    pairs->couple = NULL;
}

void hard_pairs_free(struct hard_pairs *pairs) {
    arrays_free(pairs);
    history_destroy(&pairs->history);
    history_rows_free(&pairs->rows);
}

/* True if this rank solves a pair of the list, which stands in a block of rows or of copies. */
static bool is_mine(const struct pairlist *list, const struct particles *p, bool newton,
                    const struct pair_visit *pair) {
    uint32_t i = pair->i, j = pair->j;
    if (i >= p->owned)
        return false;
    if (j < p->owned || newton || p->id[i] != p->id[j])
        return j < p->owned || newton || p->id[i] < p->id[j];
    for (int d = 0; d < 3; d++) { /* a particle and its own copy */
        double apart = p->state[j].x[d] + list->shift[pair->image][d] - p->state[i].x[d];
        if (apart != 0.0)
            return apart > 0.0;
    }
    return false;
}

/* Collects the pairs in the order of the list; returns their number. */
static size_t collect(const struct pairlist *list, const struct particles *p, bool newton, uint32_t (*end)[2],
                      uint8_t *image, uint32_t *number) {
    size_t count = 0;
    struct pair_visit pair = pairlist_all(list);
    while (pairlist_each(list, &pair)) {
        if (pair.block->kind == PAIR_BLOCK_MIRROR || !is_mine(list, p, newton, &pair))
            continue;
        end[count][0] = pair.i;
        end[count][1] = pair.j;
        image[count] = (uint8_t)pair.image;
        number[count++] = (uint32_t)pair.k;
    }
    return count;
}

/* The place of each pair of the list among the coloured pairs; UINT32_MAX: it has none. */
static uint32_t *places_of(const struct hard_pairs *pairs, const struct pairlist *list) {
    uint32_t *place = memory_allocate(list->capacity, sizeof *place, what);
    memset(place, 0xff, list->capacity * sizeof *place);
#pragma omp parallel for schedule(static)
    for (size_t m = 0; m < pairs->colours.pairs; m++)
        place[pairs->number[m]] = (uint32_t)m;
    return place;
}

/* Images of a particle are at least this far apart; INFINITY: there are none. */
static double images_apart(const struct box *box) {
    double apart = INFINITY;
    for (int d = 0; d < 3; d++)
        if (box->periodic[d])
            apart = fmin(apart, box->edge[d]);
    return apart;
}

static struct hard_couple *couple_of(const struct hard_pairs *pairs, size_t m) {
    return pairs->resists ? &pairs->couple[m] : NULL;
}

/* Gives the pairs what their rows remember. */
static void attach(struct hard_pairs *pairs, const struct pairlist *list, const struct particles *p,
                   const struct box *box) {
    history_attach(pairs->history, &pairs->rows, list, p, images_apart(box));
    uint32_t *place = places_of(pairs, list);
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < list->threads; t++) {
        const struct history_part *part = &pairs->history->part[pairs->history->now][t];
        for (size_t r = 0; r < part->count; r++) {
            uint32_t m = place[pairlist_thread_first(list, t) + part->pair[r]];
            const double *value = part->value + r * (size_t)pairs->history->components;
            if (m != UINT32_MAX)
                hard_memory_get(pairs, value, &pairs->memory[m], couple_of(pairs, m));
        }
    }
    memory_free(place);
}

/* The colours of pairs whose members act on the bodies that carry them. */
static void colours_carried(struct hard_colours *colours, size_t count, const uint32_t (*end)[2],
                            const uint8_t *image, const struct particles *p,
                            const struct hard_clumps *clumps) {
    uint32_t(*carrier)[2] = memory_allocate(count, sizeof *carrier, what);
    int64_t(*tie)[2] = memory_allocate(count, sizeof *tie, what);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < count; k++)
        for (int e = 0; e < 2; e++) {
            carrier[k][e] = hard_clumps_carrier(clumps, end[k][e]);
            tie[k][e] = p->id[end[k][e]];
        }
    hard_colours_make(colours, count, (const uint32_t(*)[2])carrier, image, (const int64_t(*)[2])tie,
                      p->owned + p->ghosts, p->id);
    memory_free(carrier);
    memory_free(tie);
}

void hard_pairs_make(struct hard_pairs *pairs, const struct pairlist *list, const struct particles *particles,
                     const struct box *box, bool newton, const struct hard_clumps *clumps) {
    size_t room = list->pair_count;
    uint32_t(*end)[2] = memory_allocate(room, sizeof *end, what);
    uint32_t *number = memory_allocate(room, sizeof *number, what);
    uint8_t *image = memory_allocate(room, 1, what);
    size_t count = collect(list, particles, newton, end, image, number);
    arrays_free(pairs);
    if (clumps->links)
        colours_carried(&pairs->colours, count, (const uint32_t(*)[2])end, image, particles, clumps);
    else
        hard_colours_make(&pairs->colours, count, (const uint32_t(*)[2])end, image, NULL,
                          particles->owned + particles->ghosts, particles->id);
    pairs->end = memory_allocate(count, sizeof *end, what);
    pairs->image = memory_allocate(count, 1, what);
    pairs->number = memory_allocate(count, sizeof *number, what);
    pairs->memory = memory_allocate_zero(count, sizeof *pairs->memory, what);
    if (pairs->resists)
        pairs->couple = memory_allocate_zero(count, sizeof *pairs->couple, what);
#pragma omp parallel for schedule(static)
    for (size_t m = 0; m < count; m++) {
        uint32_t k = pairs->colours.order[m];
        memcpy(pairs->end[m], end[k], sizeof end[k]);
        pairs->image[m] = image[k];
        pairs->number[m] = number[k];
    }
    memory_free(end);
    memory_free(image);
    memory_free(number);
    if (pairs->rows.start)
        attach(pairs, list, particles, box);
}

static bool is_known(const struct hard_memory *memory) {
    return memory->push != 0.0;
}

void hard_pairs_detach(struct hard_pairs *pairs, const struct pairlist *list,
                       const struct particles *particles) {
    if (pairs->rows.start)
        return;
    struct history *history = pairs->history;
    uint32_t *place = places_of(pairs, list);
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < (list->block_count ? list->threads : 0); t++) {
        struct history_part *part = &history->part[1 - history->now][t];
        size_t first = pairlist_thread_first(list, t), count = 0;
        struct pair_visit pair = pairlist_thread(list, t);
        while (pairlist_each(list, &pair))
            count += place[pair.k] != UINT32_MAX && is_known(&pairs->memory[place[pair.k]]);
        history_reserve(history, t, count);
        part->count = 0;
        pair = pairlist_thread(list, t);
        while (pairlist_each(list, &pair)) {
            if (place[pair.k] == UINT32_MAX || !is_known(&pairs->memory[place[pair.k]]))
                continue;
            uint32_t m = place[pair.k];
            hard_memory_put(pairs, &pairs->memory[m], couple_of(pairs, m),
                            part->value + part->count * (size_t)history->components);
            part->pair[part->count++] = (uint32_t)(pair.k - first);
        }
    }
    memory_free(place);
    history_flip(history);
    history_detach(history, list, particles, true, &pairs->rows);
}
