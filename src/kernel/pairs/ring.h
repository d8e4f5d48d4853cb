/* SPDX-License-Identifier: BSD-3-Clause */
/* The plan of a sweep that moves particles after their last pair, so that a force lives in the cache from the first
 * share to the kick, and memory never sees it.
 *
 * A thread runs its blocks of the pair list in order. After block b the thread moves those of its particles that b
 * is the last block to read. Particles that move early in a fused sweep (sweep.h: other threads or ranks read them,
 * or walls act on them) move at the end, when all their shares are summed.
 *
 * Records. The force of particle k lies in record k + shift[k / SWEEP_CHUNK] of the array of forces. A chunk whose rows all
 * belong to one thread and move after a block borrows the records of a chunk that has moved already, the last one
 * that became free: its records are still in the cache, and zero, as a move clears them. All other particles and the
 * copies use their own records. So a thread touches few records again and again: as many as there are
 * particles between the first look at a particle and its last pair, about a layer of cells.
 *
 * Invariants, which ring_valid checks:
 *   - every particle moves exactly once: after a block of its thread, or at the end;
 *   - no later block of its thread, and no other thread, reads a particle that moves after a block;
 *   - no two particles use one record at the same time: from the first look at a particle to its move, and for
 *     particles that move at the end, and copies, always. */
#ifndef SCREE_PAIRS_RING_H
#define SCREE_PAIRS_RING_H

#include "kernel/pairs/sweep.h"

/* One thread's part. */
struct ring_thread {
    struct sweep_range *range; /* as sweep_thread.late, in the order of the moves */
    size_t *start;   /* after block b of the thread range[start[b]] ... range[start[b + 1] - 1] move */
    size_t borrowed; /* chunks that have borrowed records */
    /* scratch, kept between rebuilds */
    uint32_t *last; /* of each chunk: the last block that reads it */
    uint32_t *free; /* chunks whose records are free, the last one on top */
    size_t range_capacity, start_capacity, last_capacity, free_capacity;
};

struct ring {
    int threads;
    const struct sweep *sweep; /* of the last ring_build; borrowed */
    struct ring_thread *thread;
    int32_t *shift; /* of each chunk of SWEEP_CHUNK particles, copies included */
    size_t shift_capacity;
};

/* The record of particle k; shift NULL: its own. */
static inline size_t ring_record(const int32_t *shift, uint32_t k) {
    return shift ? (uint32_t)((int32_t)k + shift[k / SWEEP_CHUNK]) : k;
}

struct ring *ring_create(int threads);
void ring_destroy(struct ring **ring);

/* Makes the plan for a sweep that was just built for this list; `all`: owned particles and copies. Opens its own
 * thread team. */
void ring_build(struct ring *ring, const struct sweep *sweep, const struct pairlist *list, size_t owned,
                size_t all);

/* True if the invariants hold; else `why` gets one line. Tests call it. */
bool ring_valid(const struct ring *ring, const struct sweep *sweep, const struct pairlist *list, size_t owned,
                size_t all, char *why, size_t why_size);

#endif
