/* SPDX-License-Identifier: BSD-3-Clause */
/* The particles of each group (a size class, or a grid of several classes), in memory order. */
#ifndef SCREE_INDEX_GRIDS_MEMBERS_H
#define SCREE_INDEX_GRIDS_MEMBERS_H

#include "index/index.h"

#include <string.h>

/* The end of the run of bytes equal to at[begin] that begins there, `end` at most. */
static inline size_t members_run(const uint8_t *at, size_t begin, size_t end) {
    uint64_t equal, eight;
    size_t k = begin + 1;
    memset(&equal, at[begin], sizeof equal);
    for (; k + sizeof eight <= end; k += sizeof eight) {
        memcpy(&eight, at + k, sizeof eight);
        if (eight != equal) {
            break;
        }
    }
    while (k < end && at[k] == at[begin]) {
        k++;
    }
    return k;
}

struct members {
    size_t first;                      /* number of the first particle of the range that was split */
    size_t begin[INDEX_CLASS_MAX + 1]; /* group g has the entries begin[g] ... begin[g + 1] */
    bool contiguous;                   /* entry k is particle first + k; else list[k] */
    uint32_t *list;
    size_t capacity;
};

/* Splits the particles [first, last) of the view by group_of[class], 0 ... groups - 1. Opens a team of
 * threads. */
void members_split(struct members *members, const struct index_view *view, size_t first, size_t last,
                   const int *group_of);
void members_free(struct members *members);

/* The particle that is entry k. */
static inline size_t members_get(const struct members *members, size_t k) {
    return members->contiguous ? members->first + k : members->list[k];
}

#endif
