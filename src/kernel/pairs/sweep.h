/* SPDX-License-Identifier: BSD-3-Clause */
/* The plan of a fused sweep: when each particle moves, so that one visit to the memory serves the drift and
 * the forces.
 *
 * A thread runs its blocks of the pair list in order. Before block b the thread moves those of its particles
 * that b is the first block to read and that have not moved yet: the late particles. A particle that other
 * threads read, too, moves early: before all blocks, and a barrier follows. Early are
 *   - particles in pairs that cross threads (both copies of such a pair read both particles),
 *   - particles of busy classes, which every thread reads,
 *   - particles that have copies elsewhere which pairs use: their values are sent before the sweep.
 *
 * Forces of the last step must be complete when the sweep begins, and a particle's record is set to zero when
 * it moves; so each contribution of this step comes after. The order of contributions is that of the plain
 * order: the same bits.
 *
 * Ranges, not particles: the rows of a thread are cut at multiples of SWEEP_CHUNK and where early and late
 * meet; a chunk moves as a whole, with its first use. Up to SWEEP_GAP late rows between early ones move with
 * these. */
#ifndef SCREE_PAIRS_SWEEP_H
#define SCREE_PAIRS_SWEEP_H

#include "kernel/pairs/pairlist.h"

enum { SWEEP_CHUNK = 256, SWEEP_GAP = 16 };

/* Particles first ... last-1, of one size class and one thread. */
struct sweep_range {
    uint32_t first, last;
    int size_class;
};

/* One thread's part. */
struct sweep_thread {
    struct sweep_range *early, *late;
    size_t early_count, late_count;
    size_t *start; /* block b of the thread (0: its first) moves late[start[b]] ... late[start[b + 1] - 1] */
    /* scratch, kept between rebuilds */
    struct sweep_range *unsorted;
    uint32_t *use; /* of each chunk: the first block that reads the chunk */
    size_t early_capacity, late_capacity, start_capacity, use_capacity;
};

struct sweep {
    int threads;
    bool stale; /* set by the code that builds the pair list again; sweep_build clears it */
    struct sweep_thread *thread;
    uint8_t *early; /* owned entries: 1 where a particle moves early */
    size_t early_capacity;
};

struct sweep *sweep_create(int threads);
void sweep_destroy(struct sweep **sweep);

/* Makes the plan for a pair list that was just built for `owned` particles; `sent` are the numbers of the particles whose
 * values travel in a step (ghosts_step_originals), in any order. Opens its own team. */
void sweep_build(struct sweep *sweep, const struct pairlist *list, size_t owned, const uint32_t *sent,
                 size_t sent_count);

/* True if every particle moves exactly once, and none after a block of its thread that reads it or while
 * another thread may; else `why` gets one line. Tests call it. */
bool sweep_valid(const struct sweep *sweep, const struct pairlist *list, size_t owned, char *why,
                 size_t why_size);

#endif
