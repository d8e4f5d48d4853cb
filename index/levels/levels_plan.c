/* SPDX-License-Identifier: BSD-3-Clause */
/* The tables that the rows of each class search (the table at the head of levels.h). Classes that do not meet
 * shorten it: a row leaves out the tables without a partner. If a table holds classes that the row's class
 * meets and classes that it does not meet, the exact test separates the candidates. */
#include "index/levels/levels_plan.h"

#include "index/prices.h"

#include <math.h>

void levels_plan_apart(struct levels_plan *plan, const struct index_view *view) {
    const struct levels_plan together = *plan;
    int renamed[INDEX_CLASS_MAX]; /* the new number of each grid; -1: none yet */
    plan->grids = 0;
    for (int g = 0; g < INDEX_CLASS_MAX; g++) {
        renamed[g] = -1;
    }
    for (int c = 0; c < view->classes; c++) {
        const int old = together.grid_of[c];
        const bool meets = grid_frame_partner(view, c) >= 0;
        int grid = meets ? renamed[old] : -1;
        if (grid < 0) {
            grid = plan->grids++;
            plan->edge[grid] = together.edge[old];
            plan->fixed[grid] = together.fixed[old];
            plan->idle[grid] = !meets;
            renamed[old] = meets ? grid : renamed[old];
        }
        plan->grid_of[c] = grid;
    }
}

/* The partners of class c in a grid. */
struct partners {
    double least, most; /* margins */
    double radius_max;
    bool some, all; /* c meets some, all of the grid's classes */
};

static struct partners partners_of(const struct levels *levels, const struct index_view *view, int c, int g) {
    struct partners partners = {.least = INFINITY, .most = -INFINITY, .all = true};
    for (int other = 0; other < view->classes; other++) {
        if (levels->plan.grid_of[other] != g) {
            continue;
        }
        if (!index_wanted(view, c, other)) {
            partners.all = false;
            continue;
        }
        partners.some = true;
        partners.least = fmin(partners.least, view->margin[c][other]);
        partners.most = fmax(partners.most, view->margin[c][other]);
        partners.radius_max = fmax(partners.radius_max, view->radius_max[other]);
    }
    return partners;
}

/* The share of the squared filter cut-off that is certain. Let c be the filter's cut-off, and a the largest
 * excess of c over the true cut-off, plus the tolerance: ((c - a) / c)^2 is smallest for the smallest c. */
static float certain_share(const struct levels *levels, double smallest, double excess) {
    double share = 1 - excess / smallest;
    if (levels->frame.clamped || !(share > 0.5 && smallest > 0)) {
        return -INFINITY;
    }
    return (float)(share * share * (1 - 0x1p-15));
}

/* The largest number of pencils of the table that a row meets: that of the largest row. */
static double pencils_of(const struct search *search, const struct cells *rows) {
    const struct grid *grid = &search->level->grid;
    double reach = search->reach + rows->r_max, pencils = 1;
    for (int d = 1; d < 3; d++) {
        pencils *= fmin(grid->n[d], 2 * reach / grid->size[d] + 1);
    }
    return pencils;
}

/* The search of rows of class c in the table of grid g, with these partners. */
static struct search search_of(const struct levels *levels, const struct index_view *view, int c, int g,
                               bool ghosts, const struct partners *partners) {
    int own = levels->plan.grid_of[c];
    const struct level *level = &levels->level[g];
    const struct cells *cells = ghosts ? &level->ghosts : &level->owned;
    const struct cells *rows = &levels->level[own].owned;
    const struct frame *frame = &levels->frame;
    const double excess_factor = 1 + 4 * CELLS_RADIUS_EXCESS;
    double tolerance = frame->tolerance, r_max = cells->r_max;
    double highest = (partners->most * frame->scale + tolerance) * excess_factor;
    double smallest = (double)rows->r_min + cells->r_min + partners->least * frame->scale;
    double excess = 2.1 * tolerance + (partners->most - partners->least) * frame->scale;
    if (!partners->all) {
        r_max = fmin(r_max, partners->radius_max * frame->scale * excess_factor);
    }
    struct search search = {.level = level, .cells = cells, .margin = (float)highest};
    search.half = !ghosts && g == own;
    search.single = !ghosts && g < own;
    search.home = ghosts && g == own && view->newton;
    search.beyond = ghosts && !(frame->periodic[0] && frame->periodic[1] && frame->periodic[2]);
    search.reach = (float)((r_max + highest) * excess_factor + 4 * tolerance) + cells->drift;
    search.direct = !levels->plan.stencils && !cells->sparse &&
                    (search.half || (search.single && pencils_of(&search, rows) <= LEVELS_PENCILS_DIRECT));
    search.certain = search.home || !partners->all ? -INFINITY : certain_share(levels, smallest, excess);
    return search;
}

static void searches_add(struct levels *levels, struct searches *searches, const struct index_view *view,
                         int c, int g, bool ghosts) {
    const struct level *level = &levels->level[g];
    const struct cells *cells = ghosts ? &level->ghosts : &level->owned;
    const struct partners partners = partners_of(levels, view, c, g);
    if (partners.some && cells->count > 0 && levels->level[levels->plan.grid_of[c]].owned.count > 0) {
        searches->list[c][searches->count[c]++] = search_of(levels, view, c, g, ghosts, &partners);
    }
}

/* Makes a stencil for class c in a plan with stencils, for the largest possible row. A stencil with more runs
 * than particles to find is not worth its memory and time: then windows replace the stencil, and go through
 * the occupied pencils. */
static void make_stencils(struct levels *levels, const struct index_view *view, int c) {
    struct level *level = &levels->level[levels->plan.grid_of[c]];
    struct search *search = levels->searches.list[c];
    const int count = levels->searches.count[c];
    double reach = 0;
    for (int s = 0; s < count; s++) {
        reach = fmax(reach, search[s].reach);
    }
    reach += levels->radius_max[c] * levels->frame.scale * (1 + 4 * CELLS_RADIUS_EXCESS);
    bool made = stencil_make(&levels->stencil[c], &level->grid, &levels->frame, (float)reach,
                             LEVELS_CELLS_A_PARTICLE * view->total + LEVELS_CELLS_FREE);
    for (int s = 0; s < count; s++) {
        bool worth =
            made && (!search[s].cells->sparse || levels->stencil[c].count <= 2 * search[s].cells->pencils);
        search[s].stencil = worth ? &levels->stencil[c] : NULL;
    }
}

/* True if owned pairs between the grids g < h are found from the larger side. */
static bool from_larger(const struct levels *levels, const struct index_view *view, int g, int h) {
    const struct frame *frame = &levels->frame;
    const struct level *small = &levels->level[g], *large = &levels->level[h];
    if (levels->cross_search != INDEX_CROSS_AUTO) {
        return levels->cross_search == INDEX_CROSS_LARGER;
    }
    double margin = 0;
    bool some = false;
    for (int c = 0; c < view->classes; c++) {
        if (levels->plan.grid_of[c] == h) {
            const struct partners partners = partners_of(levels, view, c, g);
            some = some || partners.some;
            margin = fmax(margin, partners.most * frame->scale);
        }
    }
    if (!some) {
        return false;
    }
    double reach = small->owned.r_max + large->owned.r_max + margin;
    struct prices_sides sides = {.smaller = (double)small->owned.count,
                                 .larger = (double)large->owned.count,
                                 .pencils = 1,
                                 .sparse = small->owned.sparse};
    sides.found_smaller = sides.smaller;
    sides.found_larger = sides.larger;
    for (int d = 0; d < 3; d++) {
        double extent = fmax((double)frame->owned_high[d] - frame->owned_low[d], 1e-3 * reach);
        double cells = fmin(small->grid.n[d], 2 * reach / small->grid.size[d] + 1);
        sides.pencils *= d > 0 ? cells : 1;
        sides.found_smaller *= fmin(1, (2 * reach + small->grid.size[d]) / extent);
        sides.found_larger *= fmin(1, (2 * reach + small->grid.size[d] + large->grid.size[d]) / extent);
    }
    if (sides.sparse) {
        sides.pencils = fmin(sides.pencils, (double)small->owned.pencils);
    }
    return prices_from_larger(&sides);
}

void levels_plan_searches(struct levels *levels, const struct index_view *view) {
    const struct levels_plan *plan = &levels->plan;
    struct searches *searches = &levels->searches, *cross = &levels->cross_searches;
    bool larger[INDEX_CLASS_MAX][INDEX_CLASS_MAX];
    for (int h = 0; h < plan->grids; h++) {
        for (int g = 0; g < h; g++) {
            larger[g][h] = from_larger(levels, view, g, h);
        }
    }
    for (int c = 0; c < view->classes; c++) {
        int own = plan->grid_of[c];
        searches->count[c] = cross->count[c] = 0;
        for (int g = 0; g < own; g++) {
            if (larger[g][own]) {
                searches_add(levels, cross, view, c, g, false);
            }
        }
        for (int g = own; g < plan->grids; g++) {
            if (g == own || !larger[own][g]) {
                searches_add(levels, searches, view, c, g, false);
            }
        }
        for (int g = view->newton ? own : 0; g < plan->grids; g++) {
            searches_add(levels, searches, view, c, g, true);
        }
        if (plan->stencils && searches->count[c] > 0) {
            make_stencils(levels, view, c);
        }
    }
}
