/* SPDX-License-Identifier: BSD-3-Clause */
/* The slots of a table, which cells.c, cells_slots.c and cells_follow.c fill: for these files alone. */
#ifndef SCREE_INDEX_GRIDS_CELLS_SLOTS_H
#define SCREE_INDEX_GRIDS_CELLS_SLOTS_H

#include "index/grids/cells_table.h"
#include "index/grids/levels_parts.h"

#include <omp.h>
#include <string.h>

struct cells_range {
    size_t begin, end;
};

/* Floats that are not negative compare as their bits do; compilers turn a maximum of whole numbers into vector
 * instructions, but not one of floats, of which one might be no number. */
static inline int32_t cells_bits(float x) {
    int32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}
static inline float cells_float(int32_t bits) {
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* The share of the calling thread. Inside a parallel region. */
static inline struct cells_range cells_share(size_t count) {
    size_t threads = (size_t)omp_get_num_threads();
    size_t thread = (size_t)omp_get_thread_num();
    return (struct cells_range){count * thread / threads, count * (thread + 1) / threads};
}

/* `array`, or where it has fewer than `count` entries (`old` of them) another one in its place, contents undefined. */
void *cells_ensure(void *array, size_t old, size_t count, size_t size, const char *what);

/* Makes room for the numbers of `count` particles; with `coordinates` also for coordinates and radii. */
void cells_slots_reserve(struct cells *cells, size_t count, bool coordinates);

/* Fills the slots behind the last one with a place far from every particle, as searches read whole vectors. */
void cells_slots_pad(const struct cells *cells);

/* Puts the particles of a batch into the slots from `slot` on, and updates the bounds of `cells`, which is the thread's
 * own copy. */
void cells_slots_put(struct cells *cells, const struct frame *frame, size_t slot,
                     const struct located *located);

/* Numbers of the members of the group from the k-th on; and each particle gets the number of its slot. */
void cells_slots_number(uint32_t *particle, const struct cells_source *source, size_t k, size_t n);
void cells_slots_tell(const struct cells *cells, int threads, uint32_t *slot_of);

/* Gathers the coordinates of all slots by their particle numbers. Opens a team of threads. */
void cells_slots_gather(struct cells *cells, const struct cells_source *source);

/* Bounds before the first slot; and what a thread, with its own copy of the table, adds to them. */
void cells_bounds_start(struct cells *cells);
void cells_bounds_merge(struct cells *cells, const struct cells *mine, bool ordered);

/* Reads the members of the group, from the k-th on, into a batch. */
void cells_locate(struct located *located, const struct cells_source *source, size_t k);

#endif
