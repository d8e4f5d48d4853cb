/* SPDX-License-Identifier: BSD-3-Clause */
/* When particles stay in their slots. Read levels_stay.h first.
 *
 * A sort costs a fixed share of a rebuild; a search after moves costs more than one after a sort by the growth of
 * the volume that it looks at. All that the searches since the last sort have cost in excess is what the run has paid
 * for not sorting; once the next search would raise that sum above the price of a sort, the particles are sorted (the
 * rule of those who rent skis: never more than twice the cost of the best choice in hindsight). The rule looks at
 * distances alone and measures no time, so that every run decides in the same way. */
#include "index/levels/levels_stay.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

/* Seconds of order and reorder over those of a search, of 712 thousand spheres, bidisperse, R = 10, two threads. */
static const double PRICE_OF_ORDER = 0.7;
/* A table that searches have to look at by so much more is built. */
static const double GROWTH_MOST = 0.5;

bool levels_same_grids(const struct levels_plan *a, const struct levels_plan *b, int classes) {
    bool same = a->grids == b->grids;
    for (int c = 0; c < classes && same; c++) {
        same = a->grid_of[c] == b->grid_of[c];
    }
    for (int g = 0; g < a->grids && same; g++) {
        same = a->edge[g] == b->edge[g] && a->fixed[g] == b->fixed[g] && a->idle[g] == b->idle[g];
    }
    return same;
}

/* An upper bound of the cut-offs. */
static double cutoff_most(const struct index_view *view) {
    double most = 0;
    for (int a = 0; a < view->classes; a++) {
        for (int b = 0; b <= a; b++) {
            if (index_wanted(view, a, b)) {
                most = fmax(most, view->radius_max[a] + view->radius_max[b] + view->margin[a][b]);
            }
        }
    }
    return most;
}

/* True if no pair can meet in more than one image, also after a drift of half a cut-off. */
static bool box_thick(const struct index_view *view) {
    const double reach = cutoff_most(view);
    bool thick = true;
    for (int d = 0; d < 3; d++) {
        thick = thick && (!view->periodic[d] || view->edge[d] > 4 * reach);
    }
    return thick;
}

static bool same_box(const struct levels *levels, const struct index_view *view) {
    bool same = true;
    for (int d = 0; d < 3; d++) {
        same = same && levels->frame.periodic[d] == view->periodic[d] &&
               (!view->periodic[d] || levels->stay.edge[d] == view->edge[d]);
    }
    return same;
}

bool levels_stay_pays(const struct levels *levels, const struct levels_plan *plan,
                      const struct index_view *view) {
    const struct levels_stay *stay = &levels->stay;
    if (!stay->sorted || levels->owned.begin[INDEX_CLASS_MAX] != view->owned || !same_box(levels, view) ||
        !box_thick(view) || !levels_same_grids(plan, &levels->plan, view->classes)) {
        return false;
    }
    double next = stay->builds > 0 ? stay->growth * (stay->builds + 1) / stay->builds : 0;
    return next <= GROWTH_MOST && stay->owing + next <= PRICE_OF_ORDER;
}

/* The growth of the volume that the rows of a grid look at in their own table. */
static double growth_of(const struct level *level) {
    const double reach = 2.0 * level->owned.r_max;
    double before = 1, after = 1;
    for (int d = 0; d < 3; d++) {
        double cells = (double)level->grid.size[d] + 2 * reach;
        before *= cells;
        after *= cells + 2.0 * level->owned.drift;
    }
    return after / before - 1;
}

static void reserve_turns(struct levels_stay *stay, const struct index_view *view) {
    if (view->total > stay->capacity || stay->turn == NULL) {
        memory_free(stay->turn);
        stay->turn = memory_allocate(view->total, 1, "images of particles");
        stay->capacity = view->total;
    }
    memset(stay->turn + view->owned, 0, view->total - view->owned);
}

bool levels_stay_follow(struct levels *levels, const struct index_view *view) {
    struct levels_stay *stay = &levels->stay;
    double growth = 0, half = 0.25 * cutoff_most(view) * levels->frame.scale;
    bool near = true;
    if (stay->builds == 0) {
        grid_frame_loosen(&levels->frame);
    }
    reserve_turns(stay, view);
    stay->turned = false;
    stay->builds++;
    for (int g = 0; g < levels->plan.grids; g++) {
        struct level *level = &levels->level[g];
        if (levels->plan.idle[g] || level->owned.count == 0) {
            continue;
        }
        struct cells_source source = {.view = view,
                                      .frame = &levels->frame,
                                      .grid = &level->grid,
                                      .members = &levels->owned,
                                      .group = g};
        stay->turned = cells_follow(&level->owned, &source, stay->turn) || stay->turned;
        levels->frame.clamped = levels->frame.clamped || level->owned.clamped;
        near = near && level->owned.drift < half;
        growth += growth_of(level) * (double)level->owned.count / (double)view->owned;
    }
    stay->growth = growth;
    stay->owing += growth;
    return near && growth <= GROWTH_MOST;
}

void levels_stay_note(struct levels *levels, const struct index_view *view, bool in_slots) {
    struct levels_stay *stay = &levels->stay;
    stay->due = false;
    stay->sorted = in_slots && view->owned > 0 && !levels->plan.stencils && !levels->frame.clamped;
    for (int g = 0; g < levels->plan.grids; g++) {
        const struct cells *cells = &levels->level[g].owned;
        stay->sorted = stay->sorted && (levels->plan.idle[g] || cells->count == 0 || !cells->sparse);
    }
    for (int d = 0; d < 3; d++) {
        stay->edge[d] = view->edge[d];
    }
}

void levels_stay_free(struct levels_stay *stay) {
    memory_free(stay->turn);
    *stay = (struct levels_stay){0};
}
