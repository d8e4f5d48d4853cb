#include "contact/force.h"
#include "contact/force_kernel.h"
#include "core/memory.h"
#include <assert.h>
#include <string.h>

struct force_loop {
    const struct force_kernel *kernel;
    int threads;
    struct force_thread **thread; /* each in pages of its own */
    size_t slot_doubles;          /* in use, a thread */
    size_t slot_capacity;
    struct force_ordered *ordered; /* NULL: forces are added at once */
};

struct force_loop *force_loop_create(int threads) {
    struct force_loop *loop = memory_allocate_zero(1, sizeof *loop, "force loop");
    loop->kernel = force_kernel_find(NULL);
    loop->threads = threads;
    loop->thread = memory_allocate_zero((size_t)threads, sizeof *loop->thread, "force loop");
    for (int t = 0; t < threads; t++)
        loop->thread[t] = memory_allocate_zero(1, sizeof *loop->thread[t], "batch of the force loop");
    return loop;
}

void force_loop_destroy(struct force_loop **loop) {
    if (*loop == NULL)
        return;
    for (int t = 0; t < (*loop)->threads; t++) {
        memory_free((*loop)->thread[t]->slots);
        memory_free((*loop)->thread[t]);
    }
    force_ordered_destroy(&(*loop)->ordered);
    memory_free((*loop)->thread);
    memory_free(*loop);
    *loop = NULL;
}

const char *force_loop_kernel(const struct force_loop *loop) {
    return loop->kernel->name;
}

bool force_loop_choose(struct force_loop *loop, const char *kernel) {
    const struct force_kernel *found = force_kernel_find(kernel);
    if (found)
        loop->kernel = found;
    return found != NULL;
}

/* Ready for the first block: nothing summed, nothing remembered, old records from the start. */
static void force_loop_reset(struct force_loop *loop, struct history *history) {
    for (int t = 0; t < loop->threads; t++) {
        struct force_thread *thread = loop->thread[t];
        thread->cursor = 0;
        thread->sums = (struct force_sums){0};
        if (loop->slot_doubles > 0)
            memset(thread->slots, 0, loop->slot_doubles * sizeof(double));
        if (history)
            history->part[1 - history->now][t].count = 0;
    }
    if (loop->ordered)
        force_ordered_clear(loop->ordered);
}

/* Ledgers for the threads where forces are summed in order, and none where not. */
static void force_loop_set_ordered(struct force_loop *loop, bool ordered) {
    if (ordered == (loop->ordered != NULL))
        return;
    if (ordered)
        loop->ordered = force_ordered_create(loop->threads);
    else
        force_ordered_destroy(&loop->ordered);
    for (int t = 0; t < loop->threads; t++)
        loop->thread[t]->ledger = ordered ? force_ordered_ledger(loop->ordered, t) : NULL;
}

void force_loop_prepare(struct force_loop *loop, const struct force_context *context) {
    const struct pairlist *list = context->list;
    assert(list->threads == loop->threads);
    assert(context->law->range == 0.0);
    assert((context->history != NULL) == (context->law->history_components > 0));
    loop->slot_doubles = context->ordered ? 0 : list->slot_count * (size_t)context->particles->force_stride;
    for (int t = 0; t < loop->threads && loop->slot_doubles > loop->slot_capacity; t++)
        loop->thread[t]->slots =
            memory_resize(loop->thread[t]->slots, loop->slot_doubles, sizeof(double), "force slots");
    if (loop->slot_doubles > loop->slot_capacity)
        loop->slot_capacity = loop->slot_doubles;
    force_loop_set_ordered(loop, context->ordered);
    force_loop_reset(loop, context->history);
}

void force_loop_block(struct force_loop *loop, const struct force_context *context, int thread, int block) {
    const struct pairlist *list = context->list;
    struct history *history = context->history;
    const struct pair_block *work = &list->blocks[block];
    struct force_task task = {.context = context,
                              .block = work,
                              .thread = loop->thread[thread],
                              .pair_base = pairlist_thread_first(list, thread),
                              .step = law_step_of(&context->law->options, context->dt),
                              .energies = context->want_sums};
    if (history) {
        task.old = &history->part[history->now][thread];
        task.new = &history->part[1 - history->now][thread];
        history_reserve(history, thread, task.new->count + (work->end_pair - work->first_pair));
    }
    loop->kernel->block(&task);
}

/* Adds what the threads gave to the busy particles, in thread order. */
static void force_loop_add_slots(const struct force_loop *loop, const struct force_context *context) {
    size_t stride = (size_t)context->particles->force_stride;
    for (size_t s = 0; s < context->list->slot_count; s++) {
        double *force = context->particles->force + context->list->busy[s] * stride;
        for (int t = 0; t < loop->threads; t++)
            for (size_t c = 0; c < stride; c++)
                force[c] += loop->thread[t]->slots[s * stride + c];
    }
}

void force_sums_add(struct force_sums *total, const struct force_sums *part) {
    total->elastic_normal += part->elastic_normal;
    total->elastic_tangential += part->elastic_tangential;
    total->taken += part->taken;
    for (int c = 0; c < 6; c++)
        total->virial[c] += part->virial[c];
    total->contact_sides += part->contact_sides;
    total->contacts = total->contact_sides / 2;
    if (part->overlap_max > total->overlap_max) {
        total->overlap_max = part->overlap_max;
        total->overlap_id[0] = part->overlap_id[0];
        total->overlap_id[1] = part->overlap_id[1];
    }
}

void force_loop_finish(struct force_loop *loop, const struct force_context *context,
                       struct force_sums *sums) {
    if (loop->ordered)
        force_ordered_add(loop->ordered, context->particles->owned, context->particles->force,
                          (size_t)context->particles->force_stride);
    else
        force_loop_add_slots(loop, context);
    *sums = (struct force_sums){0};
    for (int t = 0; t < loop->threads; t++)
        force_sums_add(sums, &loop->thread[t]->sums);
    if (context->history)
        history_flip(context->history);
    force_loop_reset(loop, context->history);
}

void force_loop_abandon(struct force_loop *loop, const struct force_context *context) {
    force_loop_reset(loop, context->history);
}

void force_loop_run(struct force_loop *loop, const struct force_context *context, struct force_sums *sums) {
    const struct pairlist *list = context->list;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < loop->threads; t++)
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++)
            force_loop_block(loop, context, t, b);
    force_loop_finish(loop, context, sums);
}
