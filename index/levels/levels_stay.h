/* SPDX-License-Identifier: BSD-3-Clause */
/* Builds without a sort: the cell order decays slowly, so the particles stay where they are in memory, each in the
 * cell that it had at the last order, and searches reach farther by the distance that particles have moved since. For
 * levels.c alone. */
#ifndef SCREE_INDEX_LEVELS_LEVELS_STAY_H
#define SCREE_INDEX_LEVELS_LEVELS_STAY_H

#include "index/grids/levels_parts.h"

/* True if the particles may stay for the next build, and this is likely to cost less than an order. */
bool levels_stay_pays(const struct levels *levels, const struct levels_plan *plan,
                      const struct index_view *view);

/* Follows the particles of all grids. False if they have moved so far that the tables must be built. */
bool levels_stay_follow(struct levels *levels, const struct index_view *view);

/* Notes at the end of a build whether the particles may stay at the next one. */
void levels_stay_note(struct levels *levels, const struct index_view *view, bool in_slots);

/* True if the plans have the same grids for the same classes. */
bool levels_same_grids(const struct levels_plan *a, const struct levels_plan *b, int classes);

void levels_stay_free(struct levels_stay *stay);

#endif
