/* SPDX-License-Identifier: BSD-3-Clause */
/* multi: one grid for all particles, its cells from the *smallest* cut-off, and a stencil for each class,
 * long where the class has far partners. The approach of in 't Veld, Plimpton and Grest (Comput. Phys.
 * Commun. 179 (2008) 320), as section 2.1 of the ARCHER eCSE report on multi-level contact detection (2018)
 * describes it. */
#include "index/levels/levels_index.h"

static const double CELL_FACTOR = 1.0;

static void multi_plan(const struct index_params *params, const struct index_view *view,
                       struct levels_plan *plan) {
    plan->grids = 1;
    plan->stencils = true;
    plan->edge[0] =
        levels_index_factor(params, CELL_FACTOR) * grid_frame_cutoffs(view, 0, view->classes - 1).smallest;
}

static struct index *multi_create(const struct index_params *params) {
    return levels_index_create(params, multi_plan);
}

extern const struct index_ops multi_ops;
const struct index_ops multi_ops = {
    .name = "multi",
    .summary = "one grid, cells from the smallest cut-off, a stencil for each size class",
    .create = multi_create,
    LEVELS_INDEX_OPERATIONS,
};
