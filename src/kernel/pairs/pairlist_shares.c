/* SPDX-License-Identifier: BSD-3-Clause */
/* Second copies of pairs on their way to other threads, in a build of a pair list. Read pairlist_build.h first. */
#include "base/memory.h"
#include "kernel/pairs/pairlist_build.h"
#include <string.h>

enum { SHARES_FIRST = 1 << 14 };

static void buffer_reserve(struct pair_buffer *buffer, size_t count) {
    if (count <= buffer->capacity)
        return;
    buffer->capacity = count + count / 8 + SHARES_FIRST;
    memory_free(buffer->i);
    memory_free(buffer->j);
    buffer->i = memory_allocate(buffer->capacity, sizeof *buffer->i, "pair buffer");
    buffer->j = memory_allocate(buffer->capacity, sizeof *buffer->j, "pair buffer");
}

void pairlist_shares_meet(struct pairlist *list, int t) {
    struct pairlist_build *build = list->build;
    const struct pair_buffer *ghost = &build->worker[t].ghost;
    for (size_t k = 0; k < ghost->count; k++) {
        uint8_t *thread = &build->thread_of[pair_partner(ghost->j[k])];
        uint8_t present = __atomic_load_n(thread, __ATOMIC_RELAXED);
        while (t < present && !__atomic_compare_exchange_n(thread, &present, (uint8_t)t, true,
                                                           __ATOMIC_RELAXED, __ATOMIC_RELAXED))
            continue;
    }
}

/* What decides which thread takes a pair. */
struct takers {
    const struct pairlist *list;
    const struct index_view *view; /* of ghosts */
};

/* The thread that takes the second copy of pair k of thread t. */
static int mirror_taker(const struct takers *takers, const struct pair_buffer *pairs, int t, size_t k) {
    (void)t;
    return takers->list->build->thread_of[pairs->i[k]];
}

/* PAIR_NO_THREAD: none. */
static int ghost_taker(const struct takers *takers, const struct pair_buffer *pairs, int t, size_t k) {
    uint32_t partner = pair_partner(pairs->j[k]);
    int thread = takers->list->build->thread_of[partner];
    bool none = thread == t || takers->list->build->busy_class[takers->view->size_class[partner]];
    return none ? PAIR_NO_THREAD : thread;
}

/* Sorts pairs by the threads that take them, so that no thread looks through the pairs of all. */
static inline void shares_fill(const struct takers *takers, int t, const struct pair_buffer *from,
                               struct pair_shares *to,
                               int (*taker)(const struct takers *, const struct pair_buffer *, int, size_t)) {
    size_t at = 0;
    memset(to->end, 0, sizeof to->end);
    for (size_t k = 0; k < from->count; k++) {
        int thread = taker(takers, from, t, k);
        if (thread != PAIR_NO_THREAD)
            to->end[thread]++;
    }
    for (int thread = 0; thread < takers->list->threads; thread++) {
        size_t count = to->end[thread];
        to->end[thread] = at;
        at += count;
    }
    buffer_reserve(&to->pairs, at);
    for (size_t k = 0; k < from->count; k++) {
        int thread = taker(takers, from, t, k);
        if (thread == PAIR_NO_THREAD)
            continue;
        to->pairs.i[to->end[thread]] = from->i[k];
        to->pairs.j[to->end[thread]++] = from->j[k];
    }
}

void pairlist_shares_mirrors(struct pairlist *list, int t) {
    struct pairlist_worker *worker = &list->build->worker[t];
    shares_fill(&(struct takers){list, NULL}, t, &worker->mirror, &worker->mirrors, mirror_taker);
}

void pairlist_shares_ghosts(struct pairlist *list, const struct index_view *view, int t) {
    struct pairlist_worker *worker = &list->build->worker[t];
    shares_fill(&(struct takers){list, view}, t, &worker->ghost, &worker->ghosts, ghost_taker);
}
