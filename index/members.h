/* Which particles belong to which group (a size class, or a grid of several), each group's in memory order.
 */
#ifndef SCREE_INDEX_MEMBERS_H
#define SCREE_INDEX_MEMBERS_H

#include "index/index.h"

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
