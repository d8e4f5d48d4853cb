/* SPDX-License-Identifier: BSD-3-Clause */
/* The slots of a table: room, coordinates, numbers. Read cells_slots.h first. */
#include "index/grids/cells_slots.h"

#include "base/clones.h"
#include "base/memory.h"
#include "index/grids/cells_sort.h"

#include <assert.h>
#include <string.h>

void *cells_ensure(void *array, size_t old, size_t count, size_t size, const char *what) {
    if (old >= count && array != NULL) {
        return array;
    }
    memory_free(array);
    return memory_allocate(count, size, what);
}

void cells_slots_reserve(struct cells *cells, size_t count, bool coordinates) {
    size_t old = cells->capacity;
    cells->particle = cells_ensure(cells->particle, old, count, sizeof(uint32_t), "index particles");
    cells->capacity = count > old ? count : old;
    if (!coordinates) {
        return;
    }
    old = cells->place_capacity;
    cells->x = cells_ensure(cells->x, old, count, sizeof(float), "index coordinates");
    cells->y = cells_ensure(cells->y, old, count, sizeof(float), "index coordinates");
    cells->z = cells_ensure(cells->z, old, count, sizeof(float), "index coordinates");
    cells->r = cells_ensure(cells->r, old, count, sizeof(float), "index radii");
    cells->place_capacity = count > old ? count : old;
}

/* Fills the slots behind the last one with a place far from every particle, as searches read whole
 * vectors. */
void cells_slots_pad(const struct cells *cells) {
    static_assert(MEMORY_ALIGNMENT / sizeof(float) >= CELLS_PAD, "arrays are padded by a cache line");
    for (size_t k = cells->count; k < cells->count + CELLS_PAD; k++) {
        cells->x[k] = cells->y[k] = cells->z[k] = 1e30f;
        cells->r[k] = 0;
        cells->particle[k] = 0;
    }
}

/* Radii of n slots in the frame's unit, and the bits of their bounds. */
SCREE_CLONES static void radii_put(float *restrict to, const double *restrict radius, size_t n, double scale,
                                   int32_t bounds[2]) {
    int32_t least = bounds[0], most = bounds[1];
    for (size_t k = 0; k < n; k++) {
        to[k] = (float)(radius[k] * scale * (1 + CELLS_RADIUS_EXCESS));
    }
    for (size_t k = 0; k < n; k++) {
        const int32_t bits = cells_bits(to[k]);
        least = bits < least ? bits : least;
        most = bits > most ? bits : most;
    }
    bounds[0] = least;
    bounds[1] = most;
}

/* Puts the particles of a batch into the slots from `slot` on, and updates the bounds of `cells`, which is
 * the thread's own copy. */
void cells_slots_put(struct cells *cells, const struct frame *frame, size_t slot,
                     const struct located *located) {
    const size_t n = located->count;
    int32_t bounds[2] = {cells_bits(cells->r_min), cells_bits(cells->r_max)};
    memcpy(cells->x + slot, located->x[0], n * sizeof(float));
    memcpy(cells->y + slot, located->x[1], n * sizeof(float));
    memcpy(cells->z + slot, located->x[2], n * sizeof(float));
    radii_put(cells->r + slot, located->r, n, frame->scale, bounds);
    cells->r_min = cells_float(bounds[0]);
    cells->r_max = cells_float(bounds[1]);
}

void cells_bounds_start(struct cells *cells) {
    cells->clamped = false;
    cells->drift = 0;
    cells->r_min = cells->count > 0 ? 1e30f : 0;
    cells->r_max = 0;
}

void cells_bounds_merge(struct cells *cells, const struct cells *mine, bool ordered) {
#pragma omp critical(scree_cells_bounds)
    {
        cells->r_min = mine->r_min < cells->r_min ? mine->r_min : cells->r_min;
        cells->r_max = mine->r_max > cells->r_max ? mine->r_max : cells->r_max;
        cells->drift = mine->drift > cells->drift ? mine->drift : cells->drift;
        cells->clamped = cells->clamped || mine->clamped;
        cells->in_order = cells->in_order && ordered;
    }
}

/* Reads the members of the group, from the k-th on, into a batch. */
void cells_locate(struct located *located, const struct cells_source *source, size_t k) {
    const struct members *members = source->members;
    size_t at = members->begin[source->group] + k;
    locate_particles(located, source->view, source->frame, members->contiguous ? NULL : members->list + at,
                     members->first + at);
}

void cells_slots_number(uint32_t *particle, const struct cells_source *source, size_t k, size_t n) {
    const struct members *members = source->members;
    size_t at = members->begin[source->group] + k;
    for (size_t m = 0; m < n; m++) {
        particle[m] = (uint32_t)members_get(members, at + m);
    }
}

void cells_slots_gather(struct cells *cells, const struct cells_source *source) {
#pragma omp parallel num_threads(source->view->threads) if (cells->count > CELLS_THREADED)
    {
        struct cells_range range = cells_share(cells->count);
        struct cells mine = *cells;
        struct located located;
        for (size_t slot = range.begin; slot < range.end; slot += located.count) {
            located.count = range.end - slot < LOCATE_BATCH ? range.end - slot : LOCATE_BATCH;
            locate_particles(&located, source->view, source->frame, cells->particle + slot, 0);
            cells_slots_put(&mine, source->frame, slot, &located);
        }
    }
}

void cells_slots_tell(const struct cells *cells, int threads, uint32_t *slot_of) {
#pragma omp parallel for num_threads(threads) if (cells->count > CELLS_THREADED)
    for (size_t slot = 0; slot < cells->count; slot++) {
        slot_of[cells->particle[slot]] = (uint32_t)slot;
    }
}
