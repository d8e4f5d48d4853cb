/* SPDX-License-Identifier: BSD-3-Clause */
/* bytype: one grid for each size class. Like particles are searched one-sidedly in their own grid; of unlike
 * ones the smaller look up the larger, or the larger the smaller where that costs less (cross.h); with newton
 * off owned large ones look up small ghosts too. After section 3 of the ARCHER eCSE report on multi-level
 * contact detection (2018), which became the style `multi` of LAMMPS. */
#include "index/levels/levels_index.h"

static const double CELL_FACTOR = 1.4;

static void bytype_plan(const struct index_params *params, const struct index_view *view,
                        struct levels_plan *plan) {
    plan->grids = view->classes;
    for (int c = 0; c < view->classes; c++) {
        plan->grid_of[c] = c;
        plan->edge[c] = levels_index_factor(params, CELL_FACTOR) * grid_frame_cutoffs(view, c, c).largest;
    }
}

static struct index *bytype_create(const struct index_params *params) {
    return levels_index_create(params, bytype_plan);
}

extern const struct index_ops bytype_ops;
const struct index_ops bytype_ops = {
    .name = "bytype",
    .summary = "one grid for each size class",
    .create = bytype_create,
    LEVELS_INDEX_OPERATIONS,
};
