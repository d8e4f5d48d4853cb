/* SPDX-License-Identifier: BSD-3-Clause */
/* Items sorted by the rank that they concern, for migrate.c and copies.c: the step between the list of items
 * to send and one message per neighbour. Time and memory grow with the number of items, not with the number
 * of ranks. */
#ifndef SCREE_COMM_RANK_GROUPS_H
#define SCREE_COMM_RANK_GROUPS_H

#include <stddef.h>
#include <stdint.h>

/* Group g belongs to rank[g] (increasing) and holds item[start[g]] ... item[start[g + 1] - 1], in their
 * order. */
struct groups {
    size_t count;
    int *rank;
    size_t *start; /* count + 1 entries */
    uint32_t *item;
};

/* Sorts the items 0 ... n-1 by rank[item], each in 0 ... size-1; stable. _free releases the arrays. */
void rank_groups_make(struct groups *groups, const int *rank, size_t n, int size);
void rank_groups_free(struct groups *groups);

#endif
