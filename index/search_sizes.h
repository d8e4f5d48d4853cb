/* SPDX-License-Identifier: BSD-3-Clause */
/* Sizes of the search's loops, which its cost depends on. */
#ifndef SCREE_INDEX_SEARCH_SIZES_H
#define SCREE_INDEX_SEARCH_SIZES_H

enum {
    SEARCH_ROWS = 32,     /* rows that are searched together in a table of others, at most */
    SEARCH_OWN_ROWS = 12, /* rows that are searched together in their own table, at most */
    SEARCH_LANES = 8,     /* candidates that are tested together, as the model counts them */
    SEARCH_LONG =
        16 /* windows with more candidates take a number of turns that the processor cannot foresee */
};

#endif
