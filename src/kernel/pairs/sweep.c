/* SPDX-License-Identifier: BSD-3-Clause */
/* Plans a fused sweep: which particles move early, in which order blocks go. Read sweep.h first. */
#include "kernel/pairs/sweep.h"
#include "base/memory.h"
#include "index/grids/members.h"
#include <stdio.h>
#include <string.h>

struct sweep *sweep_create(int threads) {
    struct sweep *sweep = memory_allocate_zero(1, sizeof *sweep, "plan of the sweep");
    sweep->threads = threads;
    sweep->thread = memory_allocate_zero((size_t)threads, sizeof *sweep->thread, "plan of the sweep");
    return sweep;
}

void sweep_destroy(struct sweep **sweep) {
    if (*sweep == NULL)
        return;
    for (int t = 0; t < (*sweep)->threads; t++) {
        struct sweep_thread *thread = &(*sweep)->thread[t];
        memory_free(thread->early);
        memory_free(thread->late);
        memory_free(thread->unsorted);
        memory_free(thread->start);
        memory_free(thread->use);
    }
    memory_free((*sweep)->thread);
    memory_free((*sweep)->early);
    memory_free(*sweep);
    *sweep = NULL;
}

/* Several threads may mark one particle; most find the mark, and leave the cache line where it is. */
static void early_mark_one(struct sweep *sweep, uint32_t k) {
    if (!__atomic_load_n(&sweep->early[k], __ATOMIC_RELAXED))
        __atomic_store_n(&sweep->early[k], 1, __ATOMIC_RELAXED);
}

/* Marks the particles that other threads read in a block of kind MIRROR or GHOST. */
static void early_mark_block(struct sweep *sweep, const struct pairlist *list, int b, size_t owned) {
    bool mirror = list->blocks[b].kind == PAIR_BLOCK_MIRROR;
    struct pair_visit pair = pairlist_block(b);
    while (pairlist_each(list, &pair)) {
        if (mirror)
            early_mark_one(sweep, pair.i);
        if (mirror || pair.i >= owned)
            early_mark_one(sweep, pair.j); /* beside a copy: the mirror image of a pair of another thread */
    }
}

static void early_mark(struct sweep *sweep, const struct pairlist *list, size_t owned, const uint32_t *sent,
                       size_t sent_count) {
    if (owned > sweep->early_capacity) {
        sweep->early_capacity = owned + owned / 8;
        memory_free(sweep->early);
        sweep->early = memory_allocate(sweep->early_capacity, 1, "early particles");
    }
#pragma omp parallel
    {
#pragma omp for schedule(static)
        for (size_t k = 0; k < owned; k++)
            sweep->early[k] = 0;
#pragma omp for schedule(static, 1) nowait
        for (int t = 0; t < list->threads; t++)
            for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++)
                if (list->blocks[b].kind != PAIR_BLOCK_ROWS)
                    early_mark_block(sweep, list, b, owned);
#pragma omp for schedule(static) nowait
        for (size_t s = 0; s < list->slot_count; s++)
            if (list->busy[s] < owned)
                early_mark_one(sweep, list->busy[s]);
#pragma omp for schedule(static) nowait
        for (size_t k = 0; k < sent_count; k++)
            early_mark_one(sweep, sent[k]);
    }
}

static void *grown(void *array, size_t *capacity, size_t count, size_t size) {
    if (count <= *capacity)
        return array;
    *capacity = count + count / 4 + 64;
    return memory_resize(array, *capacity, size, "plan of the sweep");
}

/* Stores for each chunk the first block of thread t that reads the chunk. The loop runs from the last block
 * back, so that the number of the first block remains. */
static void uses_find(struct sweep_thread *thread, const struct pairlist *list, int t, size_t owned) {
    size_t chunks = owned / SWEEP_CHUNK + 1;
    thread->use = grown(thread->use, &thread->use_capacity, chunks, sizeof *thread->use);
    memset(thread->use, 0xff, chunks * sizeof *thread->use);
    uint32_t *use = thread->use;
    for (int b = list->thread_block[t + 1] - 1; b >= list->thread_block[t]; b--) {
        const struct pair_block *block = &list->blocks[b];
        const uint32_t number = (uint32_t)(b - list->thread_block[t]);
        const bool ghosts = block->kind == PAIR_BLOCK_GHOST;
        struct pair_visit pair = pairlist_block(b);
        while (pairlist_each(list, &pair))
            if (!ghosts || pair.j < owned)
                use[pair.j / SWEEP_CHUNK] = number;
        for (uint32_t row = block->first_row; row < block->last_row; row += SWEEP_CHUNK)
            use[row / SWEEP_CHUNK] = number;
        if (block->last_row > block->first_row)
            use[(block->last_row - 1) / SWEEP_CHUNK] = number;
    }
}

static void range_add(struct sweep_thread *thread, bool early, struct sweep_range range) {
    if (early) {
        thread->early = grown(thread->early, &thread->early_capacity, thread->early_count + 1, sizeof range);
        thread->early[thread->early_count++] = range;
        return;
    }
    size_t capacity = thread->late_capacity;
    thread->late = grown(thread->late, &thread->late_capacity, thread->late_count + 1, sizeof range);
    if (thread->late_capacity != capacity)
        thread->unsorted =
            memory_resize(thread->unsorted, thread->late_capacity, sizeof range, "plan of the sweep");
    thread->unsorted[thread->late_count++] = range;
}

/* Where the range of row `first` ends. An early range takes late rows between early ones along, since short
 * ranges cost more than moving a few rows before their block. */
static uint32_t range_end(const uint8_t *early, uint32_t first, uint32_t end) {
    uint32_t last = (uint32_t)members_run(early, first, end);
    while (early[first] && last < end) {
        uint32_t next = (uint32_t)members_run(early, last, end);
        if (next == end || next - last > SWEEP_GAP)
            break;
        last = (uint32_t)members_run(early, next, end);
    }
    return last;
}

/* Cuts the rows of a block into ranges of one chunk, early or late. */
static void ranges_cut(struct sweep_thread *thread, const uint8_t *early, const struct pair_block *block) {
    for (uint32_t first = block->first_row; first < block->last_row;) {
        uint32_t grain_end = (first / SWEEP_CHUNK + 1) * SWEEP_CHUNK;
        uint32_t end = grain_end < block->last_row ? grain_end : block->last_row;
        uint32_t last = range_end(early, first, end);
        range_add(thread, early[first], (struct sweep_range){first, last, block->size_class});
        first = last;
    }
}

/* Sorts the late ranges by the block that moves them. */
static void ranges_sort(struct sweep_thread *thread, size_t blocks) {
    thread->start = grown(thread->start, &thread->start_capacity, blocks + 2, sizeof *thread->start);
    memset(thread->start, 0, (blocks + 2) * sizeof *thread->start);
    size_t *at = thread->start + 1;
    for (size_t r = 0; r < thread->late_count; r++)
        at[thread->use[thread->unsorted[r].first / SWEEP_CHUNK] + 1]++;
    for (size_t b = 0; b < blocks; b++)
        at[b + 1] += at[b];
    for (size_t r = 0; r < thread->late_count; r++)
        thread->late[at[thread->use[thread->unsorted[r].first / SWEEP_CHUNK]]++] = thread->unsorted[r];
}

void sweep_build(struct sweep *sweep, const struct pairlist *list, size_t owned, const uint32_t *sent,
                 size_t sent_count) {
    sweep->stale = false;
    early_mark(sweep, list, owned, sent, sent_count);
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < sweep->threads; t++) {
        struct sweep_thread *thread = &sweep->thread[t];
        uses_find(thread, list, t, owned);
        thread->early_count = thread->late_count = 0;
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++)
            ranges_cut(thread, sweep->early, &list->blocks[b]);
        ranges_sort(thread, (size_t)(list->thread_block[t + 1] - list->thread_block[t]));
    }
}

/* For sweep_valid: the time at which each particle moves, and its thread. */
struct sweep_moves {
    uint32_t *when; /* 0: early; b + 1: before block b of its thread; UINT32_MAX: never */
    int *thread;
};

static bool moves_note(const struct sweep *sweep, const struct pairlist *list, struct sweep_moves *moves,
                       uint32_t *twice) {
    for (int t = 0; t < sweep->threads; t++) {
        const struct sweep_thread *thread = &sweep->thread[t];
        size_t blocks = (size_t)(list->thread_block[t + 1] - list->thread_block[t]);
        for (size_t b = 0; b <= blocks; b++) {
            const struct sweep_range *range = b == 0 ? thread->early : thread->late;
            size_t first = b == 0 ? 0 : thread->start[b - 1];
            size_t last = b == 0 ? thread->early_count : thread->start[b];
            for (size_t r = first; r < last; r++)
                for (uint32_t k = range[r].first; k < range[r].last; k++) {
                    *twice = k;
                    if (moves->when[k] != UINT32_MAX)
                        return false;
                    moves->when[k] = (uint32_t)b;
                    moves->thread[k] = t;
                }
        }
    }
    return true;
}

static bool moves_precede(const struct pairlist *list, const struct sweep_moves *moves, size_t owned,
                          uint32_t *late) {
    for (int t = 0; t < list->threads; t++) {
        struct pair_visit pair = pairlist_thread(list, t);
        while (pairlist_each(list, &pair))
            for (int side = 0; side < 2; side++) {
                uint32_t p = side ? pair.j : pair.i, block = (uint32_t)(pair.number - list->thread_block[t]);
                *late = p;
                if (p < owned && moves->when[p] > 0 && (moves->thread[p] != t || moves->when[p] > block + 1))
                    return false;
            }
    }
    return true;
}

bool sweep_valid(const struct sweep *sweep, const struct pairlist *list, size_t owned, char *why,
                 size_t why_size) {
    struct sweep_moves moves = {memory_allocate(owned, sizeof *moves.when, "check of the sweep"),
                                memory_allocate(owned, sizeof *moves.thread, "check of the sweep")};
    uint32_t wrong = 0;
    for (size_t k = 0; k < owned; k++)
        moves.when[k] = UINT32_MAX;
    bool good = moves_note(sweep, list, &moves, &wrong);
    if (!good)
        snprintf(why, why_size, "particle %u moves twice", wrong);
    for (size_t k = 0; good && k < owned; k++)
        if (moves.when[k] == UINT32_MAX) {
            snprintf(why, why_size, "particle %zu does not move", k);
            good = false;
        }
    if (good && !moves_precede(list, &moves, owned, &wrong)) {
        snprintf(why, why_size, "particle %u moves after it is read", wrong);
        good = false;
    }
    memory_free(moves.when);
    memory_free(moves.thread);
    return good;
}
