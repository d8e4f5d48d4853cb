/* SPDX-License-Identifier: BSD-3-Clause */
/* hgrid: a hierarchy of grids. Each level holds a run of neighbouring size classes and has its own cell size;
 * a particle searches its own level, and all coarser or finer ones (Ogarko and Luding, Comput. Phys. Commun.
 * 183 (2012) 931; Krijgsman, Ogarko and Luding, Comput. Part. Mech. 1 (2014) 357, on the choice of levels).
 */
#include "index/levels/levels_index.h"

static const double CELL_FACTOR = 1.4;

static void hgrid_plan(const struct index_params *params, const struct index_view *view,
                       struct levels_plan *plan) {
    int levels = params->levels > 0 && params->levels < view->classes ? params->levels : view->classes;
    int last = -1;
    plan->grids = levels;
    for (int level = 0; level < levels; level++) {
        int first = last + 1;
        last = view->classes * (level + 1) / levels - 1;
        for (int c = first; c <= last; c++) {
            plan->grid_of[c] = level;
        }
        double given = params->level_cell[level];
        plan->edge[level] = given > 0 ? given
                                      : levels_index_factor(params, CELL_FACTOR) *
                                            grid_frame_cutoffs(view, first, last).largest;
        plan->fixed[level] = plan->fixed[level] || given > 0;
    }
}

static struct index *hgrid_create(const struct index_params *params) {
    return levels_index_create(params, hgrid_plan);
}

extern const struct index_ops hgrid_ops;
const struct index_ops hgrid_ops = {
    .name = "hgrid",
    .summary = "a hierarchy of grids: each run of size classes on a level of its own cell size",
    .create = hgrid_create,
    LEVELS_INDEX_OPERATIONS,
};
