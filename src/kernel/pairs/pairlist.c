/* SPDX-License-Identifier: BSD-3-Clause */
/* The life of a pair list, its slots, and whether it still holds all pairs. Read pairlist.h first. */
#include "kernel/pairs/pairlist.h"
#include "base/checksum.h"
#include "base/memory.h"
#include "kernel/pairs/pairlist_build.h"
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { BLOCK_ROWS_DEFAULT = 2048 };
static const double busy_bound_default = 48;

struct pairlist *pairlist_create(const struct pairlist_options *options) {
    assert(options->threads >= 1 && options->threads <= PAIR_THREADS_MAX);
    struct pairlist *list = memory_allocate_zero(1, sizeof *list, "pair list");
    list->threads = options->threads;
    list->thread_block =
        memory_allocate_zero((size_t)options->threads + 1, sizeof *list->thread_block, "pair list threads");
    struct pairlist_build *build = memory_allocate_zero(1, sizeof *build, "pair list build");
    build->worker =
        memory_allocate_zero((size_t)options->threads, sizeof *build->worker, "pair list workers");
    build->block_rows = options->block_rows ? options->block_rows : BLOCK_ROWS_DEFAULT;
    build->busy_bound = options->busy_bound > 0 ? options->busy_bound : busy_bound_default;
    list->build = build;
    return list;
}

int64_t pairlist_sides(const struct pairlist *list) {
    size_t sides = (size_t)list->sides;
    for (int b = 0; b < list->block_count; b++) {
        const struct pair_block *block = &list->blocks[b];
        size_t one = block->slotted - block->one_sided;
        sides += 2 * (block->end_pair - block->first_pair) - one;
    }
    return (int64_t)sides;
}

void pair_buffer_free(struct pair_buffer *buffer) {
    memory_free(buffer->i);
    memory_free(buffer->j);
}

static void worker_release(struct pairlist_worker *worker) {
    struct pair_buffer *const buffer[] = {&worker->one,           &worker->slot,         &worker->mirror,
                                          &worker->mirrors.pairs, &worker->ghosts.pairs, &worker->ghost};
    memory_free(worker->sink.i);
    memory_free(worker->sink.j);
    worker->sink = (struct index_sink){0};
    worker->first = worker->room = 0;
    for (size_t k = 0; k < sizeof buffer / sizeof *buffer; k++) {
        pair_buffer_free(buffer[k]);
        *buffer[k] = (struct pair_buffer){0};
    }
}

void pairlist_release(struct pairlist *list) {
    list->sides = pairlist_sides(list);
    for (int t = 0; t < list->threads; t++)
        worker_release(&list->build->worker[t]);
    memory_free(list->build->thread_of);
    list->build->thread_of = NULL;
    list->build->thread_of_capacity = 0;
    memory_free(list->i);
    memory_free(list->j);
    list->i = list->j = NULL;
    list->capacity = 0;
    for (int b = 0; b < list->block_count; b++) {
        struct pair_block *block = &list->blocks[b];
        block->first_pair = block->one_sided = block->slotted = block->end_pair = 0;
    }
}

void pairlist_destroy(struct pairlist **list) {
    struct pairlist *l = *list;
    if (l == NULL)
        return;
    pairlist_release(l);
    memory_free(l->build->worker);
    memory_free(l->build->run);
    memory_free(l->build);
    memory_free(l->blocks);
    memory_free(l->thread_block);
    memory_free(l->busy);
    memory_free(l->slot_of);
    memory_free(l);
    *list = NULL;
}

void pairlist_view(struct index_view *view, const struct particles *particles,
                   const struct size_classes *classes, const struct box *box, const bool wrap[3]) {
    *view = (struct index_view){
        .owned = particles->owned,
        .total = particles->owned + particles->ghosts,
        .position = particles->state[0].x,
        .radius = &particles->state[0].radius,
        .stride = sizeof(struct particle_state) / sizeof(double),
        .size_class = particles->size_class,
        .id = particles->id,
        .dimension = box->dimension,
        .classes = classes->count,
    };
    _Static_assert((int)INDEX_CLASS_MAX == (int)CLASS_MAX, "the index serves all size classes");
    for (int d = 0; d < 3; d++) {
        view->edge[d] = box->edge[d];
        view->periodic[d] = box->periodic[d] && wrap[d];
    }
    for (int a = 0; a < classes->count; a++) {
        view->radius_max[a] = classes->radius_max[a];
        for (int b = 0; b < classes->count; b++)
            view->margin[a][b] = classes->margin[a][b];
    }
}

void pairlist_reserve_slots(struct pairlist *list, size_t particles, size_t slots) {
    if (particles > list->slot_of_capacity) {
        list->slot_of_capacity = particles + particles / 8;
        list->slot_of = memory_resize(list->slot_of, list->slot_of_capacity, sizeof *list->slot_of, "slots");
    }
    if (slots > list->busy_capacity) {
        list->busy_capacity = slots + slots / 8;
        list->busy = memory_resize(list->busy, list->busy_capacity, sizeof *list->busy, "busy particles");
    }
}

static size_t buffer_bytes(const struct pair_buffer *buffer) {
    return buffer->capacity * 2 * sizeof(uint32_t);
}

size_t pairlist_memory(const struct pairlist *list) {
    size_t bytes = (list->capacity * 2 + list->slot_of_capacity + list->busy_capacity) * sizeof(uint32_t) +
                   list->build->thread_of_capacity + list->build->run_capacity * sizeof *list->build->run;
    for (int t = 0; t < list->threads; t++) {
        const struct pairlist_worker *w = &list->build->worker[t];
        bytes += w->sink.capacity * 2 * sizeof(uint32_t) + buffer_bytes(&w->one) + buffer_bytes(&w->slot) +
                 buffer_bytes(&w->mirror) + buffer_bytes(&w->ghost) + buffer_bytes(&w->mirrors.pairs) +
                 buffer_bytes(&w->ghosts.pairs);
    }
    return bytes;
}

/* How far the two of a pair are beyond their margin; infinite for classes that are not wanted. */
static double pair_gap(const struct pairlist *list, const struct index_view *view,
                       const struct pair_visit *pair) {
    uint32_t i = pair->i, j = pair->j;
    const double *xi = view->position + i * view->stride, *xj = view->position + j * view->stride;
    const double *shift = list->shift[pair->image];
    double d2 = 0;
    for (int d = 0; d < 3; d++) {
        double dx = xj[d] + shift[d] - xi[d];
        d2 += dx * dx;
    }
    double reach = view->radius[i * view->stride] + view->radius[j * view->stride] +
                   view->margin[view->size_class[i]][view->size_class[j]];
    return sqrt(d2) - reach;
}

bool pairlist_valid(const struct pairlist *list, const struct index_view *view, char *why, size_t why_size) {
    struct pair_visit pair = pairlist_all(list);
    while (pairlist_each(list, &pair)) {
        const struct pair_block *block = pair.block;
        uint32_t i = pair.i, j = pair.j;
        bool inside = i < view->total && j < view->total && i != j;
        bool row = block->kind != PAIR_BLOCK_ROWS || (i >= block->first_row && i < block->last_row);
        if (inside && row && pair_gap(list, view, &pair) <= 1e-9 * view->radius[i * view->stride])
            continue;
        snprintf(why, why_size, "block %d (rows %u ... %u): pair %zu is (%u, %u)", pair.number,
                 block->first_row, block->last_row, pair.k, i, j);
        return false;
    }
    return true;
}

void pairlist_follow(struct pairlist *list, const struct box *box) {
    list->moves = box->motion.moves;
    box_image_shifts(box, list->shift);
    if (list->moves)
        box_image_velocities(box, list->drift);
}

/* The image of j with the copy's own image taken in; the row is the copy where i is one. */
static uint32_t image_joined(uint32_t i, uint32_t code, size_t owned, const uint8_t *image) {
    uint32_t j = pair_partner(code);
    int found[3], copy[3], sign = i < owned ? 1 : -1;
    image_vector(pair_image(code), found);
    image_vector(image[(i < owned ? j : i) - owned], copy);
    unsigned sum =
        image_code(found[0] + sign * copy[0], found[1] + sign * copy[1], found[2] + sign * copy[2]);
    return j | sum << PARTICLE_INDEX_BITS;
}

/* Before the first pair of a thread with a copy. */
static struct pair_visit ghost_block(const struct pairlist *list, int t) {
    int block = list->thread_block[t + 1] - 1;
    assert(list->blocks[block].kind == PAIR_BLOCK_GHOST);
    return pairlist_block(block);
}

void pairlist_add_images(struct pairlist *list, size_t owned, const uint8_t *image) {
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < list->threads; t++) {
        struct pair_visit pair = ghost_block(list, t);
        while (pairlist_each(list, &pair))
            list->j[pair.k] = image_joined(pair.i, list->j[pair.k], owned, image);
    }
}

static void mark_copy(uint8_t *used, uint32_t k, size_t owned) {
    if (k < owned)
        return;
#pragma omp atomic write
    used[k - owned] = 1;
}

void pairlist_mark_copies(const struct pairlist *list, size_t owned, uint8_t *used) {
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < list->threads; t++) {
        struct pair_visit pair = ghost_block(list, t);
        while (pairlist_each(list, &pair)) {
            mark_copy(used, pair.i, owned);
            mark_copy(used, pair.j, owned);
        }
    }
}

uint64_t pairlist_owners(const struct pairlist *list) {
    uint64_t sum =
        checksum_row((uint64_t)list->threads, list->build->busy_class, sizeof list->build->busy_class);
    for (int t = 0; t < list->threads && list->block_count > 0; t++)
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++) {
            const uint32_t rows[] = {(uint32_t)t, list->blocks[b].first_row, list->blocks[b].last_row};
            sum = checksum_row(sum, rows, sizeof rows);
        }
    return sum;
}
