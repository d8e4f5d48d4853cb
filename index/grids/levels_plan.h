/* Plans the searches of an index of levels. For levels.c alone. */
#ifndef SCREE_INDEX_GRIDS_LEVELS_PLAN_H
#define SCREE_INDEX_GRIDS_LEVELS_PLAN_H

#include "index/grids/levels_parts.h"

/* Sets levels->searches and cross_searches, and the stencils of a plan that has them, for tables that are
 * built. */
void levels_plan_searches(struct levels *levels, const struct index_view *view);

#endif
