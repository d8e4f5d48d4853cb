/* SPDX-License-Identifier: BSD-3-Clause */
/* Pairs of unlike levels that are found from the larger side.
 *
 * The fastest search for pairs of a few large and many small particles starts at the large ones: each large
 * particle searches the cells of the small ones around it. The small particles, nearly all of which have no
 * large partner, then search their own table alone. The row of a pair is still the smaller particle: the
 * build finds the pairs and sorts them by the number of the smaller particle, and the visit of its row emits
 * them. */
#ifndef SCREE_INDEX_GRIDS_CROSS_H
#define SCREE_INDEX_GRIDS_CROSS_H

#include "index/grids/members.h"

struct cross_pairs {
    size_t rows;       /* owned particles; 0: nothing was found from the larger side */
    uint32_t *end;     /* row i has the partners end[i - 1] (row 0: 0) ... end[i] - 1 */
    uint32_t *partner; /* with image code, ascending in a row */
    size_t row_capacity, partner_capacity;
    struct index_sink *found; /* scratch, one a thread: (larger, smaller) as they are found */
    int threads;
    struct index_sink sorted; /* scratch: all of them, by the thread that owns the row of the smaller */
    size_t *place;            /* scratch: where the finds of a thread for each owner go */
    size_t place_capacity;
};

/* The search from the larger side: its rows and its function. */
struct cross_finder {
    const struct members *owned;
    size_t first; /* place in `owned` of the first particle that searches smaller ones, as do all after it */
    const void *context;
    /* Emits the pairs of rows [first, last) with smaller particles. Many threads at once. */
    void (*find)(const void *context, const struct index_view *view, size_t first, size_t last,
                 struct index_sink *sink);
};

/* Finds the pairs and sorts them; their set and order do not depend on the number of threads. Opens teams of
 * threads. */
void cross_find(struct cross_pairs *cross, const struct cross_finder *finder, const struct index_view *view);

/* Forgets all pairs: nothing was found from the larger side. */
void cross_clear(struct cross_pairs *cross);

/* Emits the pairs of rows [first, last). Many threads at once. */
void cross_visit(const struct cross_pairs *cross, size_t first, size_t last, struct index_sink *sink);

void cross_free(struct cross_pairs *cross);

/* Bytes held. */
size_t cross_memory(const struct cross_pairs *cross);

#endif
