/* SPDX-License-Identifier: BSD-3-Clause */
/* The memory and the order of a walk over pairs; the operations on a block are in walk_block.c. */
#include "kernel/pairs/walk.h"
#include "base/memory.h"
#include "base/scan.h"
#include "kernel/pairs/walk_kernel.h"
#include <assert.h>
#include <string.h>

/* From so many slots on, those of all threads together, the team adds them up; fewer are not worth a team. */
enum { SLOTS_A_TEAM = 2048 };

/* The slots that the pairs of a thread add to, ascending. */
struct slots_used {
    uint32_t *slot;
    size_t count, capacity;
};

struct walk {
    const struct walk_client *client;
    const struct walk_kernel *kernel;
    int threads;
    struct walk_thread **thread;  /* each in pages of its own; slots are 0 between evaluations */
    struct slots_used *used;      /* a thread */
    size_t slot_capacity;         /* doubles a thread */
    size_t used_count;            /* slots that pairs add to, of all threads together */
    struct walk_ordered *ordered; /* NULL: shares are added at once */
};

struct walk *walk_create(const struct walk_client *client, int threads) {
    struct walk *walk = memory_allocate_zero(1, sizeof *walk, "walk over pairs");
    assert(client->memory >= sizeof(struct walk_batch));
    walk->client = client;
    walk->kernel = walk_kernel_get(walk_level(NULL));
    walk->threads = threads;
    walk->thread = memory_allocate_zero((size_t)threads, sizeof *walk->thread, "walk over pairs");
    walk->used = memory_allocate_zero((size_t)threads, sizeof *walk->used, "walk over pairs");
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
        memory_free((*walk)->used[t].slot);
        memory_free((*walk)->thread[t]->batch);
        memory_free((*walk)->thread[t]);
    }
    walk_ordered_destroy(&(*walk)->ordered);
    memory_free((*walk)->thread);
    memory_free((*walk)->used);
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

/* Ready for the first block: nothing remembered, old records from the start. The slots are 0. */
static void walk_reset(struct walk *walk, struct history *history) {
    for (int t = 0; t < walk->threads; t++) {
        struct walk_thread *thread = walk->thread[t];
        thread->cursor = thread->ahead = 0;
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

/* Finds the slots that the pairs of a thread add to; `mark` has a byte a slot, all 0. */
static void used_find(struct slots_used *used, const struct pairlist *list, int t, uint8_t *mark) {
    for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++)
        for (size_t k = list->blocks[b].slotted; k < list->blocks[b].end_pair; k++) {
            uint8_t *one = &mark[list->slot_of[pair_partner(list->j[k])]];
            used->count += !*one;
            *one = 1;
        }
    if (used->count > used->capacity) {
        used->capacity = used->count + used->count / 4;
        memory_free(used->slot);
        used->slot = memory_allocate(used->capacity, sizeof *used->slot, "slots of busy particles");
    }
    for (size_t s = 0, n = 0; n < used->count; s++)
        if (mark[s])
            used->slot[n++] = (uint32_t)s;
}

/* Room for the slots of the list, and the slots that each thread uses. */
static void slots_prepare(struct walk *walk, const struct walk_work *work) {
    const struct pairlist *list = work->list;
    const size_t slots = work->ordered ? 0 : list->slot_count, doubles = slots * work->stride;
    size_t used = 0;
    for (int t = 0; t < walk->threads && doubles > walk->slot_capacity; t++) {
        memory_free(walk->thread[t]->slots);
        walk->thread[t]->slots = memory_allocate_zero(doubles, sizeof(double), "slots of busy particles");
    }
    walk->slot_capacity = doubles > walk->slot_capacity ? doubles : walk->slot_capacity;
#pragma omp parallel for schedule(static, 1) reduction(+ : used) if (slots > 0)
    for (int t = 0; t < walk->threads; t++) {
        walk->used[t].count = 0;
        if (slots > 0) {
            uint8_t *mark = memory_allocate_zero(slots, 1, "slots of busy particles");
            used_find(&walk->used[t], list, t, mark);
            memory_free(mark);
            used += walk->used[t].count;
        }
    }
    walk->used_count = used;
}

void walk_prepare(struct walk *walk, const struct walk_work *work) {
    assert(work->list->threads == walk->threads);
    slots_prepare(walk, work);
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

/* Adds the threads' slots [first, last) to the busy particles, in thread order, and clears them. */
static void slots_add(const struct walk *walk, const struct walk_work *work, size_t first, size_t last) {
    const size_t stride = work->stride;
    for (int t = 0; t < walk->threads; t++) {
        const struct slots_used *used = &walk->used[t];
        for (size_t n = scan_first(used->slot, used->count, first); n < used->count && used->slot[n] < last;
             n++) {
            double *sum = work->target + work->list->busy[used->slot[n]] * stride,
                   *slot = walk->thread[t]->slots + used->slot[n] * stride;
            for (size_t c = 0; c < stride; c++) {
                sum[c] += slot[c];
                slot[c] = 0;
            }
        }
    }
}

static void walk_add_slots(const struct walk *walk, const struct walk_work *work) {
    const size_t slots = work->list->slot_count, threads = (size_t)walk->threads;
    if (walk->used_count < SLOTS_A_TEAM) {
        slots_add(walk, work, 0, slots);
        return;
    }
#pragma omp parallel for schedule(static, 1)
    for (size_t t = 0; t < threads; t++)
        slots_add(walk, work, slots * t / threads, slots * (t + 1) / threads);
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
    for (int t = 0; t < walk->threads; t++)
        for (size_t n = 0; n < walk->used[t].count; n++)
            memset(walk->thread[t]->slots + walk->used[t].slot[n] * work->stride, 0,
                   work->stride * sizeof(double));
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
