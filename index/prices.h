/* SPDX-License-Identifier: BSD-3-Clause */
/* The costs of the steps of a search, in nanoseconds: the one list of prices. `auto` chooses an index by
 * these prices (cost.h), and an index of levels chooses the side that finds pairs of unlike levels. */
#ifndef SCREE_INDEX_CHOOSE_PRICES_H
#define SCREE_INDEX_CHOOSE_PRICES_H

#include <stdbool.h>

/* Events of one rebuild. */
enum cost_term {
    COST_PARTICLE,
    COST_CELL,
    COST_MIXED,
    COST_WINDOW,
    COST_VECTOR,
    COST_LONG,
    COST_VISIT,
    COST_RUN,
    COST_ROUND,
    COST_SPARSE,
    COST_TEST,
    COST_SINGLE,
    COST_TERMS
};

/* The price of an event. */
double prices_event(enum cost_term term);

/* The two sides of a pair of levels: the number of particles of each side, the number of them around a
 * particle of the other side (larger ones: around a span of rows), and the pencils of small cells that a
 * large particle meets. */
struct prices_sides {
    double smaller, larger;
    double found_smaller, found_larger;
    double pencils;
    bool sparse; /* the table of the smaller particles is sparse */
};

/* True if the larger side finds the pairs of the two in less time. */
bool prices_from_larger(const struct prices_sides *sides);

#endif
