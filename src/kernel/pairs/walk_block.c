/* SPDX-License-Identifier: BSD-3-Clause */
/* One block of the pair list through the operations of walk.h. Compiled once for each instruction set, under the
 * name that WALK_KERNEL gives. Read walk.h first. */
#include "kernel/pairs/walk_filter.h"
#include "kernel/pairs/walk_history.h"
#include <string.h>

/* Takes out of the batch the pairs that the client does not want. */
static __attribute__((noinline)) void walk_select(const struct walk_task *task, int gathers) {
    struct walk_batch *restrict b = task->thread->batch;
    uint8_t keep[WALK_BATCH];
    int kept = 0;
    memset(keep, 1, sizeof keep);
    task->client->select(task, b, keep);
    for (int k = 0; k < b->count; k++) {
        if (!keep[k])
            continue;
        if (kept < k) {
            memcpy(b->record[kept], b->record[k], sizeof b->record[k]);
            for (int g = 0; g < gathers; g++)
                memcpy(b->gathered[g][kept], b->gathered[g][k], sizeof b->gathered[g][k]);
            b->i[kept] = b->i[k];
            b->j[kept] = b->j[k];
            b->pair[kept] = b->pair[k];
            b->radius[0][kept] = b->radius[0][k];
            b->radius[1][kept] = b->radius[1][k];
        }
        kept++;
    }
    b->count = kept;
}

/* Adds the velocities of the images, in a box that moves. */
static __attribute__((noinline)) void walk_drift(const struct walk_task *task, const uint32_t *j,
                                                 const double (*drift)[4], int count) {
    struct walk_batch *restrict b = task->thread->batch;
    for (int k = 0; k < count; k++)
        *(walk_four *)(b->record[k] + 4) +=
            *(const walk_four *)drift[pair_image(j[task->thread->candidate[k]])];
}

/* Fills the batch with the first `count` near pairs. */
static inline void walk_gather(const struct walk_task *task, const struct walk_view view, int count) {
    const struct walk_thread *restrict thread = task->thread;
    struct walk_batch *restrict b = thread->batch;
    uint32_t offset = (uint32_t)(task->block->first_pair - task->pair_base);
    for (int g = 0; g < view.gathers; g++)
        for (int k = 0; k < count; k++)
            __builtin_prefetch(view.gather[g].base +
                               pair_partner(view.j[thread->candidate[k]]) * view.gather[g].stride);
    for (int k = 0; k < count; k++) {
        uint32_t pair = thread->candidate[k], i = view.i[pair], code = view.j[pair], j = pair_partner(code);
        const struct particle_state *si = &view.state[i], *sj = &view.state[j];
        __builtin_prefetch(view.target + i * view.stride, 1);
        __builtin_prefetch(view.target + j * view.stride, 1);
        b->i[k] = i;
        b->j[k] = j;
        b->pair[k] = pair + offset;
        b->radius[0][k] = si->radius;
        b->radius[1][k] = sj->radius;
        *(walk_four *)b->record[k] =
            walk_between(si, sj, 0) + *(const walk_four *)view.shift[pair_image(code)];
        *(walk_four *)(b->record[k] + 4) = walk_between(si, sj, 1);
        for (int g = 0; g < view.gathers; g++) {
            const double *base = view.gather[g].base;
            *(walk_four *)b->gathered[g][k] = *(const walk_four *)(base + i * view.gather[g].stride);
            *(walk_four *)(b->gathered[g][k] + 4) = *(const walk_four *)(base + j * view.gather[g].stride);
        }
    }
    if (view.drift)
        walk_drift(task, view.j, view.drift, count);
    b->count = count;
    if (task->work->selective)
        walk_select(task, view.gathers);
    b->padded = (b->count + WALK_LANES - 1) / WALK_LANES * WALK_LANES;
}

/* Fills the rest of the last lanes with repeats of the last pair. */
static inline void walk_pad(struct walk_batch *b, int gathers, int components) {
    int last = b->count - 1;
    for (int k = b->count; k < b->padded; k++) {
        memcpy(b->record[k], b->record[last], sizeof b->record[k]);
        for (int g = 0; g < gathers; g++)
            memcpy(b->gathered[g][k], b->gathered[g][last], sizeof b->gathered[g][k]);
        for (int side = 0; side < 2; side++)
            b->radius[side][k] = b->radius[side][last];
        for (int c = 0; c < components; c++)
            b->history[c][k] = b->history[c][last];
        b->i[k] = b->i[last];
        b->j[k] = b->j[last];
    }
}

/* The number of the batch's pairs, which run in the order of pairs, before pair `end` of the list. */
static inline int walk_before(const struct walk_task *task, size_t end) {
    const struct walk_batch *b = task->thread->batch;
    int low = 0, high = b->count;
    while (low < high) {
        int middle = (low + high) / 2;
        if (b->pair[middle] + task->pair_base < end)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Turns three components of the batch's pairs into records x y z 0 at share[k] + offset. */
static inline void walk_transpose(struct walk_batch *restrict b, double component[3][WALK_BATCH],
                                  int offset) {
    const walk_four zero = {0.0, 0.0, 0.0, 0.0};
    for (int k = 0; k < b->padded; k += WALK_QUAD) {
        walk_four out[WALK_QUAD];
        walk_turn(out, *(const walk_four *)&component[0][k], *(const walk_four *)&component[1][k],
                  *(const walk_four *)&component[2][k], zero);
        for (int m = 0; m < WALK_QUAD; m++)
            *(walk_four *)(b->share[k + m] + offset) = out[m];
    }
}

/* The shares of all pairs as records. */
static inline void walk_share(struct walk_batch *restrict b, enum walk_scatter scatter) {
    walk_transpose(b, b->out, 0);
    if (scatter >= WALK_TORQUE)
        walk_transpose(b, b->out + 3, 4);
    if (scatter == WALK_ROLLING)
        walk_transpose(b, b->out + 6, 8);
}

/* Adds the share of pair k for i (side 0) or j (side 1) to a record. */
static inline __attribute__((always_inline)) void walk_add(double *record,
                                                           const struct walk_batch *restrict b, int k,
                                                           int side, enum walk_scatter scatter, int values) {
    if (scatter == WALK_VALUES) {
        for (int c = 0; c < values; c++)
            record[c] += b->out[side * values + c][k];
        return;
    }
    const walk_four *share = (const walk_four *)b->share[k];
    walk_four *sum = (walk_four *)record;
    sum[0] = side ? sum[0] + share[0] : sum[0] - share[0];
    if (scatter == WALK_FORCE)
        return;
    walk_four torque = share[1] * b->lever[side][k];
    if (scatter == WALK_ROLLING)
        torque = side ? torque + share[2] : torque - share[2];
    sum[1] += torque;
}

/* Doubles of a target's record. */
static inline size_t walk_stride(const struct walk_task *task, enum walk_scatter scatter) {
    return scatter >= WALK_TORQUE ? 8 : task->work->stride;
}

/* Writes down the share of pair k for i (side 0) or j (side 1), as entry `at`. */
static inline __attribute__((always_inline)) void walk_enter(const struct walk_task *task,
                                                             const struct walk_ledger ledger, size_t at,
                                                             int k, int side, enum walk_scatter scatter) {
    const struct walk_batch *b = task->thread->batch;
    const size_t stride = walk_stride(task, scatter);
    const int64_t *id = task->work->particles->id;
    unsigned image = pair_image(task->work->list->j[b->pair[k] + task->pair_base]);
    double share[WALK_VALUES_MAX] __attribute__((aligned(32))) = {0.0};
    walk_add(share, b, k, side, scatter, task->client->values);
    ledger.particle[at] = side ? b->j[k] : b->i[k];
    ledger.source[at] =
        (struct walk_source){id[side ? b->i[k] : b->j[k]], side ? image_opposite(image) : image};
    memcpy(ledger.share + at * stride, share, stride * sizeof *share);
}

/* Writes down the shares of the batch, to be summed in order. A one-sided pair has only one share here:
 * another thread or rank has the other side. */
static __attribute__((noinline)) void walk_record(const struct walk_task *task, enum walk_scatter scatter) {
    struct walk_ledger *ledger = task->thread->ledger;
    const struct walk_batch *b = task->thread->batch;
    size_t at = ledger->count;
    walk_ledger_reserve(ledger, at + 2 * (size_t)b->count, task->work->stride);
    for (int k = 0; k < b->count; k++) {
        walk_enter(task, *ledger, at++, k, 0, scatter);
        if (k < b->both || k >= b->one)
            walk_enter(task, *ledger, at++, k, 1, scatter);
    }
    ledger->count = at;
}

/* Adds the shares of the batch to the particles, by segment of the list. */
static inline __attribute__((always_inline)) void walk_scatter(const struct walk_task *task,
                                                               enum walk_scatter scatter) {
    struct walk_thread *thread = task->thread;
    const struct walk_batch *restrict b = thread->batch;
    const int32_t *slot_of = task->work->list->slot_of;
    const size_t stride = walk_stride(task, scatter);
    const int values = task->client->values, both = b->both, one = b->one, count = b->count;
    double *target = task->work->target, *slots = thread->slots;
    if (scatter != WALK_VALUES)
        walk_share(thread->batch, scatter);
    if (thread->ledger) {
        walk_record(task, scatter);
        return;
    }
    for (int k = 0; k < both; k++) {
        walk_add(target + b->i[k] * stride, b, k, 0, scatter, values);
        walk_add(target + b->j[k] * stride, b, k, 1, scatter, values);
    }
    for (int k = both; k < count; k++)
        walk_add(target + b->i[k] * stride, b, k, 0, scatter, values);
    for (int k = one; k < count; k++)
        walk_add(slots + (size_t)slot_of[b->j[k]] * stride, b, k, 1, scatter, values);
}

/* Takes the first `count` near pairs out, through a batch. */
static inline __attribute__((always_inline)) void walk_flush(const struct walk_task *task,
                                                             const struct walk_view *view, int count,
                                                             enum walk_scatter scatter, int components) {
    struct walk_thread *thread = task->thread;
    struct walk_batch *b = thread->batch;
    walk_gather(task, *view, count);
    if (b->count > 0) {
        if (components)
            walk_recall(*task->old, thread, components);
        walk_pad(b, view->gathers, components);
        b->both = walk_before(task, task->block->one_sided);
        b->one = walk_before(task, task->block->slotted);
        task->client->compute(task, b);
        if (scatter != WALK_NOTHING)
            walk_scatter(task, scatter);
        if (components)
            walk_remember(task->new, b, components);
        if (task->client->note)
            task->client->note(task, b);
    }
    thread->candidates -= (size_t)count;
    memmove(thread->candidate, thread->candidate + count, thread->candidates * sizeof thread->candidate[0]);
}

/* Takes the block through the operations, with constants for the results and the history of a pair. */
static inline __attribute__((always_inline)) void walk_through(const struct walk_task *task,
                                                               enum walk_scatter scatter, int components) {
    const struct walk_view view = walk_view_of(task);
    struct walk_thread *thread = task->thread;
    size_t pairs = task->block->end_pair - task->block->first_pair;
    thread->candidates = 0;
    for (size_t first = 0; first < pairs; first += WALK_CHUNK) {
        walk_filter_any(task, &view, first, first + WALK_CHUNK < pairs ? first + WALK_CHUNK : pairs);
        while (thread->candidates >= WALK_BATCH)
            walk_flush(task, &view, WALK_BATCH, scatter, components);
    }
    if (thread->candidates > 0)
        walk_flush(task, &view, (int)thread->candidates, scatter, components);
}

/* The usual combinations have a compiled form of their own. */
static void walk_rows(const struct walk_task *task) {
    int components = task->work->history ? task->work->history->components : 0;
    enum walk_scatter scatter = task->client->scatter;
    if (task->block->first_pair == task->block->end_pair)
        return; /* a list without pairs has no arrays */
    if (scatter == WALK_ROLLING && components == 6)
        walk_through(task, WALK_ROLLING, 6);
    else if (scatter == WALK_TORQUE && components == 3)
        walk_through(task, WALK_TORQUE, 3);
    else if (scatter == WALK_TORQUE && components == 4)
        walk_through(task, WALK_TORQUE, 4);
    else if (scatter == WALK_FORCE && components == 0)
        walk_through(task, WALK_FORCE, 0);
    else
        walk_through(task, scatter, components);
}

const struct walk_kernel WALK_KERNEL = {walk_rows};
