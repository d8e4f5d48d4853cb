/* SPDX-License-Identifier: BSD-3-Clause */
/* Divides the rows of a pair list among threads and cuts them into blocks, before any pair is known. Read pairlist_build.h
 * first. */
#include "base/memory.h"
#include "index/grids/members.h"
#include "kernel/pairs/pairlist_build.h"
#include <string.h>

/* Finds the runs of classes among the owned particles, and counts the particles of each class: one look at the
 * particles, whatever the number of threads. */
static void class_runs_find(struct pairlist_build *build, const struct index_view *view) {
    build->run_count = 0;
    memset(build->population, 0, sizeof build->population);
    for (size_t first = 0, last; first < view->owned; first = last) {
        last = members_run(view->size_class, first, view->owned);
        if (build->run_count == build->run_capacity) {
            build->run_capacity = 2 * build->run_capacity + CLASS_MAX;
            build->run =
                memory_resize(build->run, build->run_capacity, sizeof *build->run, "runs of classes");
        }
        build->run[build->run_count++] = (struct class_run){first, last, view->size_class[first]};
        build->population[view->size_class[first]] += last - first;
    }
    for (size_t first = view->owned, last; first < view->total; first = last) {
        last = members_run(view->size_class, first, view->total);
        build->population[view->size_class[first]] += last - first;
    }
}

/* The first row of thread t in a run; that of thread t + 1 is the end of its rows. */
static size_t class_run_share(const struct class_run *run, int threads, int t) {
    return run->first + (run->last - run->first) * (size_t)t / (size_t)threads;
}

static size_t blocks_add(struct pairlist *list, size_t at, struct pair_block block) {
    struct pairlist_build *build = list->build;
    if (at == (size_t)build->blocks_capacity) {
        build->blocks_capacity = 2 * build->blocks_capacity + 64;
        list->blocks =
            memory_resize(list->blocks, (size_t)build->blocks_capacity, sizeof block, "pair blocks");
    }
    list->blocks[at] = block;
    return at + 1;
}

/* Cuts the share of one thread into blocks: the t-th part of each run of a class. */
static size_t blocks_of_thread(struct pairlist *list, int t, size_t at) {
    const struct pairlist_build *build = list->build;
    size_t step = build->block_rows;
    for (size_t r = 0; r < build->run_count; r++) {
        const struct class_run *run = &build->run[r];
        size_t end = class_run_share(run, list->threads, t + 1);
        for (size_t row = class_run_share(run, list->threads, t); row < end; row += step) {
            size_t last = row + step < end ? row + step : end;
            at = blocks_add(list, at,
                            (struct pair_block){.first_row = (uint32_t)row,
                                                .last_row = (uint32_t)last,
                                                .kind = PAIR_BLOCK_ROWS,
                                                .size_class = run->size_class});
        }
    }
    at = blocks_add(list, at, (struct pair_block){.kind = PAIR_BLOCK_MIRROR});
    return blocks_add(list, at, (struct pair_block){.kind = PAIR_BLOCK_GHOST});
}

/* Writes down which thread owns each particle: each thread its own rows. */
static void threads_note(struct pairlist *list, const struct index_view *view) {
    struct pairlist_build *build = list->build;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < list->threads; t++)
        for (size_t r = 0; r < build->run_count; r++) {
            size_t begin = class_run_share(&build->run[r], list->threads, t);
            memset(build->thread_of + begin, t,
                   class_run_share(&build->run[r], list->threads, t + 1) - begin);
        }
    if (view->total > view->owned)
        memset(build->thread_of + view->owned, PAIR_NO_THREAD, view->total - view->owned);
}

void pairlist_blocks_make(struct pairlist *list, const struct index_view *view) {
    struct pairlist_build *build = list->build;
    if (view->total > build->thread_of_capacity) {
        build->thread_of_capacity = view->total + view->total / 8;
        memory_free(build->thread_of);
        build->thread_of = memory_allocate(build->thread_of_capacity, 1, "thread of each particle");
    }
    class_runs_find(build, view);
    threads_note(list, view);
    size_t at = 0;
    for (int t = 0; t < list->threads; t++) {
        list->thread_block[t] = (int)at;
        at = blocks_of_thread(list, t, at);
    }
    list->thread_block[list->threads] = (int)at;
    list->block_count = (int)at;
}
