/* SPDX-License-Identifier: BSD-3-Clause */
/* The memory and the order of a walk over pairs; the operations on a block are in walk_block.c. */
#include "kernel/pairs/walk.h"
#include "base/memory.h"
#include "kernel/pairs/walk_kernel.h"
#include <assert.h>
#include <string.h>

struct walk {
    const struct walk_client *client;
    const struct walk_kernel *kernel;
    int threads;
    struct walk_thread **thread; /* each in pages of its own */
    size_t slot_doubles;         /* in use, a thread */
    size_t slot_capacity;
    struct walk_ordered *ordered; /* NULL: shares are added at once */
};

struct walk *walk_create(const struct walk_client *client, int threads) {
    struct walk *walk = memory_allocate_zero(1, sizeof *walk, "walk over pairs");
    assert(client->memory >= sizeof(struct walk_batch));
    walk->client = client;
    walk->kernel = walk_kernel_get(walk_level(NULL));
    walk->threads = threads;
    walk->thread = memory_allocate_zero((size_t)threads, sizeof *walk->thread, "walk over pairs");
    for (int t = 0; t < threads; t++) {
        walk->thread[t] = memory_allocate_zero(1, sizeof *walk->thread[t], "walk over pairs");
        walk->thread[t]->batch = memory_allocate_zero(1, client->memory, "batch of a walk over pairs");
    }
    return walk;
}

void walk_destroy(struct walk **walk) {
    if (*walk == NULL)
        return;
    for (int t = 0; t < (*walk)->threads; t++) {
        memory_free((*walk)->thread[t]->slots);
        memory_free((*walk)->thread[t]->batch);
        memory_free((*walk)->thread[t]);
    }
    walk_ordered_destroy(&(*walk)->ordered);
    memory_free((*walk)->thread);
    memory_free(*walk);
    *walk = NULL;
}

struct walk_batch *walk_batch_of(const struct walk *walk, int thread) {
    return walk->thread[thread]->batch;
}

bool walk_choose(struct walk *walk, const char *name) {
    int level = walk_level(name);
    if (level >= 0)
        walk->kernel = walk_kernel_get(level);
    return level >= 0;
}

/* Ready for the first block: nothing summed, nothing remembered, old records from the start. */
static void walk_reset(struct walk *walk, struct history *history) {
    for (int t = 0; t < walk->threads; t++) {
        struct walk_thread *thread = walk->thread[t];
        thread->cursor = thread->ahead = 0;
        if (walk->slot_doubles > 0)
            memset(thread->slots, 0, walk->slot_doubles * sizeof(double));
        if (history)
            history->part[1 - history->now][t].count = 0;
    }
    if (walk->ordered)
        walk_ordered_clear(walk->ordered);
}

/* Ledgers for the threads where shares are summed in order, and none where not. */
static void walk_set_ordered(struct walk *walk, bool ordered) {
    if (ordered == (walk->ordered != NULL))
        return;
    if (ordered)
        walk->ordered = walk_ordered_create(walk->threads);
    else
        walk_ordered_destroy(&walk->ordered);
    for (int t = 0; t < walk->threads; t++)
        walk->thread[t]->ledger = ordered ? walk_ordered_ledger(walk->ordered, t) : NULL;
}

void walk_prepare(struct walk *walk, const struct walk_work *work) {
    const struct pairlist *list = work->list;
    assert(list->threads == walk->threads);
    walk->slot_doubles = work->ordered ? 0 : list->slot_count * work->stride;
    for (int t = 0; t < walk->threads && walk->slot_doubles > walk->slot_capacity; t++)
        walk->thread[t]->slots = memory_resize(walk->thread[t]->slots, walk->slot_doubles, sizeof(double),
                                               "slots of busy particles");
    if (walk->slot_doubles > walk->slot_capacity)
        walk->slot_capacity = walk->slot_doubles;
    walk_set_ordered(walk, work->ordered);
    walk_reset(walk, work->history);
}

void walk_block(struct walk *walk, const struct walk_work *work, int thread, int block) {
    struct history *history = work->history;
    const struct pair_block *rows = &work->list->blocks[block];
    struct walk_task task = {.client = walk->client,
                             .work = work,
                             .block = rows,
                             .thread = walk->thread[thread],
                             .pair_base = pairlist_thread_first(work->list, thread)};
    if (history) {
        task.old = &history->part[history->now][thread];
        task.new = &history->part[1 - history->now][thread];
        history_reserve(history, thread, task.new->count + (rows->end_pair - rows->first_pair));
    }
    walk->kernel->block(&task);
}

/* Adds the threads' slots to the busy particles, in thread order. */
static void walk_add_slots(const struct walk *walk, const struct walk_work *work) {
    size_t stride = work->stride;
    for (size_t s = 0; s < work->list->slot_count; s++) {
        double *sum = work->target + work->list->busy[s] * stride;
        for (int t = 0; t < walk->threads; t++)
            for (size_t c = 0; c < stride; c++)
                sum[c] += walk->thread[t]->slots[s * stride + c];
    }
}

void walk_finish(struct walk *walk, const struct walk_work *work) {
    if (walk->ordered)
        walk_ordered_add(walk->ordered, work->particles->owned, work->target, work->stride);
    else
        walk_add_slots(walk, work);
    if (work->history)
        history_flip(work->history);
    walk_reset(walk, work->history);
}

void walk_abandon(struct walk *walk, const struct walk_work *work) {
    walk_reset(walk, work->history);
}

void walk_run(struct walk *walk, const struct walk_work *work) {
    const struct pairlist *list = work->list;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < walk->threads; t++)
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++)
            walk_block(walk, work, t, b);
    walk_finish(walk, work);
}

void walk_weigh(const struct walk_batch *batch, double *weight) {
    for (int k = 0; k < WALK_BATCH; k++)
        weight[k] = 1.0;
    for (int k = batch->both; k < batch->one; k++)
        weight[k] = 0.5;
    for (int k = batch->count; k < batch->padded; k++)
        weight[k] = 0.0;
}
