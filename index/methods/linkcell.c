/* SPDX-License-Identifier: BSD-3-Clause */
/* linkcell: one grid for all particles, its cells as large as the largest cut-off. Good if all particles are
 * of about one size. If there are also large particles, each small particle searches cells full of small
 * ones. */
#include "index/levels/levels_index.h"

static const double CELL_FACTOR = 1.0;

static void linkcell_plan(const struct index_params *params, const struct index_view *view,
                          struct levels_plan *plan) {
    plan->grids = 1;
    plan->edge[0] =
        levels_index_factor(params, CELL_FACTOR) * grid_frame_cutoffs(view, 0, view->classes - 1).largest;
}

static struct index *linkcell_create(const struct index_params *params) {
    return levels_index_create(params, linkcell_plan);
}

extern const struct index_ops linkcell_ops;
const struct index_ops linkcell_ops = {
    .name = "linkcell",
    .summary = "one grid, cells from the largest cut-off: for particles of like size",
    .create = linkcell_create,
    LEVELS_INDEX_OPERATIONS,
};
