/* SPDX-License-Identifier: BSD-3-Clause */
/* Plans the grids and the searches of an index of levels. For levels.c and the files that make plans. */
#ifndef SCREE_INDEX_LEVELS_LEVELS_PLAN_H
#define SCREE_INDEX_LEVELS_LEVELS_PLAN_H

#include "index/grids/levels_parts.h"

/* Gives each class without a partner class a grid of its own, which is `idle`: its particles are in no cells
 * and search nothing. Every function that makes a plan for a view calls this function at its end. */
void levels_plan_apart(struct levels_plan *plan, const struct index_view *view);

/* Sets levels->searches and cross_searches, and the stencils of a plan that has them, for tables that are
 * built. */
void levels_plan_searches(struct levels *levels, const struct index_view *view);

#endif
