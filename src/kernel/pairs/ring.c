/* SPDX-License-Identifier: BSD-3-Clause */
/* Plans a sweep that moves particles after their last pair. Read ring.h first. */
#include "kernel/pairs/ring.h"
#include "base/memory.h"
#include <stdio.h>
#include <string.h>

/* In `last`: all rows of the chunk move after a block of this thread. */
#define RING_WHOLE (1u << 31)

struct ring *ring_create(int threads) {
    struct ring *ring = memory_allocate_zero(1, sizeof *ring, "plan of the ring");
    ring->threads = threads;
    ring->thread = memory_allocate_zero((size_t)threads, sizeof *ring->thread, "plan of the ring");
    return ring;
}

void ring_destroy(struct ring **ring) {
    if (*ring == NULL)
        return;
    for (int t = 0; t < (*ring)->threads; t++) {
        memory_free((*ring)->thread[t].range);
        memory_free((*ring)->thread[t].start);
        memory_free((*ring)->thread[t].last);
        memory_free((*ring)->thread[t].free);
    }
    memory_free((*ring)->thread);
    memory_free((*ring)->shift);
    memory_free(*ring);
    *ring = NULL;
}

static void *grown(void *array, size_t *capacity, size_t count, size_t size) {
    if (count <= *capacity)
        return array;
    *capacity = count + count / 4 + 64;
    memory_free(array);
    return memory_allocate(*capacity, size, "plan of the ring");
}

/* Stores for each chunk the last block of thread t that reads the chunk. */
static void lasts_find(struct ring_thread *thread, const struct pairlist *list, int t, size_t owned) {
    uint32_t *last = thread->last;
    for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++) {
        const struct pair_block *block = &list->blocks[b];
        const uint32_t number = (uint32_t)(b - list->thread_block[t]);
        for (uint32_t row = block->first_row; row < block->last_row; row += SWEEP_CHUNK)
            last[row / SWEEP_CHUNK] = number;
        if (block->last_row > block->first_row)
            last[(block->last_row - 1) / SWEEP_CHUNK] = number;
        struct pair_visit pair = pairlist_block(b);
        while (pairlist_each(list, &pair)) {
            if (pair.j < owned)
                last[pair.j / SWEEP_CHUNK] = number;
            if (block->kind != PAIR_BLOCK_ROWS && pair.i < owned)
                last[pair.i / SWEEP_CHUNK] = number;
        }
    }
}

/* Sorts the late ranges by the block after which they move. */
static void ranges_sort(struct ring_thread *thread, const struct sweep_thread *plan, size_t blocks) {
    size_t *at = thread->start + 1;
    memset(thread->start, 0, (blocks + 2) * sizeof *thread->start);
    for (size_t r = 0; r < plan->late_count; r++)
        at[thread->last[plan->late[r].first / SWEEP_CHUNK] + 1]++;
    for (size_t b = 0; b < blocks; b++)
        at[b + 1] += at[b];
    for (size_t r = 0; r < plan->late_count; r++)
        thread->range[at[thread->last[plan->late[r].first / SWEEP_CHUNK]]++] = plan->late[r];
}

/* The end of the run of late ranges from `r` on that lie side by side in one chunk. */
static size_t grain_end(const struct sweep_range *late, size_t r, size_t end) {
    uint32_t chunk = late[r].first / SWEEP_CHUNK;
    for (r++; r < end && late[r].first == late[r - 1].last && late[r].first / SWEEP_CHUNK == chunk; r++)
        ;
    return r;
}

/* Gives records to the chunks that the thread first reads in block b. */
static void records_take(struct ring_thread *thread, const struct sweep_thread *plan, size_t b,
                         size_t *free_count, int32_t *shift) {
    for (size_t r = plan->start[b], end; r < plan->start[b + 1]; r = end) {
        end = grain_end(plan->late, r, plan->start[b + 1]);
        uint32_t chunk = plan->late[r].first / SWEEP_CHUNK;
        if (plan->late[end - 1].last - plan->late[r].first != SWEEP_CHUNK)
            continue;
        thread->last[chunk] |= RING_WHOLE;
        if (*free_count == 0)
            continue;
        shift[chunk] = ((int32_t)thread->free[--*free_count] - (int32_t)chunk) * SWEEP_CHUNK;
        thread->borrowed++;
    }
}

/* Takes back the records of the chunks that move after block b. */
static void records_leave(struct ring_thread *thread, size_t b, size_t *free_count, const int32_t *shift) {
    for (size_t r = thread->start[b]; r < thread->start[b + 1]; r++) {
        uint32_t first = thread->range[r].first, chunk = first / SWEEP_CHUNK;
        if (first % SWEEP_CHUNK == 0 && (thread->last[chunk] & RING_WHOLE))
            thread->free[(*free_count)++] = (uint32_t)((int32_t)chunk + shift[chunk] / SWEEP_CHUNK);
    }
}

void ring_build(struct ring *ring, const struct sweep *sweep, const struct pairlist *list, size_t owned,
                size_t all) {
    size_t chunks = all / SWEEP_CHUNK + 1;
    ring->sweep = sweep;
    ring->shift = grown(ring->shift, &ring->shift_capacity, chunks, sizeof *ring->shift);
    memset(ring->shift, 0, chunks * sizeof *ring->shift);
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < ring->threads; t++) {
        struct ring_thread *thread = &ring->thread[t];
        const struct sweep_thread *plan = &sweep->thread[t];
        size_t blocks = (size_t)(list->thread_block[t + 1] - list->thread_block[t]), free_count = 0;
        thread->last = grown(thread->last, &thread->last_capacity, chunks, sizeof *thread->last);
        thread->free = grown(thread->free, &thread->free_capacity, chunks, sizeof *thread->free);
        thread->range =
            grown(thread->range, &thread->range_capacity, plan->late_count, sizeof *thread->range);
        thread->start = grown(thread->start, &thread->start_capacity, blocks + 2, sizeof *thread->start);
        thread->borrowed = 0;
        lasts_find(thread, list, t, owned);
        ranges_sort(thread, plan, blocks);
        for (size_t b = 0; b < blocks; b++) {
            records_take(thread, plan, b, &free_count, ring->shift);
            records_leave(thread, b, &free_count, ring->shift);
        }
    }
}

/* For ring_valid: what happens to each particle and record. */
struct ring_check {
    int *thread;      /* that moves the particle after a block; -1: it moves at the end; -2: not at all */
    uint32_t *when;   /* the block */
    uint32_t *holder; /* of each record: the particle + 1 whose force it holds; 0: none */
    int *user; /* of each record: the thread; -1: a particle that moves at the end, or a copy; -2: none */
};

static bool moves_note(const struct ring *ring, const struct sweep *sweep, const struct pairlist *list,
                       struct ring_check *check, uint32_t *twice) {
    for (int t = 0; t < ring->threads; t++) {
        int blocks = list->thread_block[t + 1] - list->thread_block[t];
        for (int b = -1; b < blocks; b++) {
            const struct sweep_range *range = b < 0 ? sweep->thread[t].early : ring->thread[t].range;
            size_t first = b < 0 ? 0 : ring->thread[t].start[b];
            size_t last = b < 0 ? sweep->thread[t].early_count : ring->thread[t].start[b + 1];
            for (size_t r = first; r < last; r++)
                for (uint32_t k = range[r].first; k < range[r].last; k++) {
                    *twice = k;
                    if (check->thread[k] != -2)
                        return false;
                    check->thread[k] = b < 0 ? -1 : t;
                    check->when[k] = b < 0 ? 0 : (uint32_t)b;
                }
        }
    }
    return true;
}

/* Takes the record of particle p into use by thread t before block b reads it. */
static const char *record_use(const struct ring *ring, struct ring_check *check, uint32_t p, int t,
                              uint32_t b) {
    size_t record = ring_record(ring->shift, p);
    int user = check->thread[p] < 0 ? -1 : t;
    if (check->thread[p] >= 0 && (check->thread[p] != t || check->when[p] < b))
        return "is read after it has moved";
    if (check->thread[p] < 0 && record != p)
        return "moves at the end, and does not use its own record";
    if (check->user[record] != -2 && check->user[record] != user)
        return "uses a record of another thread";
    if (check->holder[record] != 0 && check->holder[record] != p + 1)
        return "uses a record that is in use";
    check->user[record] = user;
    check->holder[record] = p + 1;
    return NULL;
}

static const char *thread_check(const struct ring *ring, const struct pairlist *list,
                                struct ring_check *check, int t, uint32_t *wrong) {
    const char *what = NULL;
    for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++) {
        const struct ring_thread *thread = &ring->thread[t];
        uint32_t number = (uint32_t)(b - list->thread_block[t]);
        struct pair_visit pair = pairlist_block(b);
        while (pairlist_each(list, &pair))
            for (int side = 0; side < 2; side++) {
                *wrong = side ? pair.j : pair.i;
                if ((what = record_use(ring, check, *wrong, t, number)))
                    return what;
            }
        for (size_t r = thread->start[number]; r < thread->start[number + 1]; r++)
            for (*wrong = thread->range[r].first; *wrong < thread->range[r].last; ++*wrong) {
                if ((what = record_use(ring, check, *wrong, t, number)))
                    return what;
                check->holder[ring_record(ring->shift, *wrong)] = 0;
            }
    }
    return NULL;
}

bool ring_valid(const struct ring *ring, const struct sweep *sweep, const struct pairlist *list, size_t owned,
                size_t all, char *why, size_t why_size) {
    struct ring_check check = {.thread = memory_allocate(all, sizeof *check.thread, "check of the ring"),
                               .when = memory_allocate_zero(all, sizeof *check.when, "check of the ring"),
                               .holder = memory_allocate_zero(all, sizeof *check.holder, "check of the ring"),
                               .user = memory_allocate(all, sizeof *check.user, "check of the ring")};
    const char *what = NULL;
    uint32_t wrong = 0;
    for (size_t k = 0; k < all; k++) {
        check.thread[k] = k < owned ? -2 : -1;
        check.user[k] = -2;
    }
    if (!moves_note(ring, sweep, list, &check, &wrong))
        what = "moves twice";
    for (size_t k = 0; what == NULL && k < owned; k++)
        if (check.thread[k] == -2) {
            what = "does not move";
            wrong = (uint32_t)k;
        }
    for (size_t k = 0; k < all; k++)
        if (check.thread[k] == -1) {
            check.user[k] = -1;
            check.holder[k] = (uint32_t)k + 1;
        }
    for (int t = 0; what == NULL && t < ring->threads; t++)
        what = thread_check(ring, list, &check, t, &wrong);
    if (what)
        snprintf(why, why_size, "particle %u %s", wrong, what);
    memory_free(check.thread);
    memory_free(check.when);
    memory_free(check.holder);
    memory_free(check.user);
    return what == NULL;
}
