/* Which tables the rows of each class search (the table at the head of levels.h). */
#include "index/grids/levels_plan.h"

#include "index/choose/prices.h"

#include <math.h>

/* Least and largest margin between class c and the classes of grid g. */
static void margin_range(const struct levels *levels, const struct index_view *view, int c, int g,
                         double range[2]) {
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (int other = 0; other < view->classes; other++) {
        if (levels->plan.grid_of[other] == g) {
            range[0] = fmin(range[0], view->margin[c][other]);
            range[1] = fmax(range[1], view->margin[c][other]);
        }
    }
}

/* The share of the squared filter cut-off that is certain. With c the filter's cut-off and a what it may
 * exceed the true one by, plus the tolerance, ((c - a) / c)^2 is smallest for the smallest c. */
static float certain_share(const struct levels *levels, double smallest, double excess) {
    double share = 1 - excess / smallest;
    if (levels->frame.clamped || !(share > 0.5)) {
        return -INFINITY;
    }
    return (float)(share * share * (1 - 0x1p-15));
}

/* Pencils of the table that a row meets, the largest at most. */
static double pencils_of(const struct search *search, const struct cells *rows) {
    const struct grid *grid = &search->level->grid;
    double reach = search->reach + rows->r_max, pencils = 1;
    for (int d = 1; d < 3; d++) {
        pencils *= fmin(grid->n[d], 2 * reach / grid->size[d] + 1);
    }
    return pencils;
}

/* Rows of class c, in the table of grid g. */
static struct search search_of(const struct levels *levels, const struct index_view *view, int c, int g,
                               bool ghosts) {
    int own = levels->plan.grid_of[c];
    const struct level *level = &levels->level[g];
    const struct cells *cells = ghosts ? &level->ghosts : &level->owned;
    const struct cells *rows = &levels->level[own].owned;
    const struct frame *frame = &levels->frame;
    double margin[2], tolerance = frame->tolerance;
    margin_range(levels, view, c, g, margin);
    double highest = (margin[1] * frame->scale + tolerance) * (1 + 4 * CELLS_RADIUS_EXCESS);
    double smallest = (double)rows->r_min + cells->r_min + margin[0] * frame->scale;
    double excess = 2.1 * tolerance + (margin[1] - margin[0]) * frame->scale;
    struct search search = {.level = level, .cells = cells, .margin = (float)highest};
    search.half = !ghosts && g == own;
    search.single = !ghosts && g < own;
    search.home = ghosts && g == own && view->newton;
    search.beyond = ghosts && frame->hollow;
    search.reach = (float)((cells->r_max + highest) * (1 + 4 * CELLS_RADIUS_EXCESS) + 4 * tolerance);
    search.direct = !levels->plan.stencils && !cells->sparse &&
                    (search.half || (search.single && pencils_of(&search, rows) <= LEVELS_PENCILS_DIRECT));
    search.certain = search.home ? -INFINITY : certain_share(levels, smallest, excess);
    return search;
}

static void searches_add(struct levels *levels, struct searches *searches, const struct index_view *view,
                         int c, int g, bool ghosts) {
    const struct level *level = &levels->level[g];
    const struct cells *cells = ghosts ? &level->ghosts : &level->owned;
    if (cells->count > 0 && levels->level[levels->plan.grid_of[c]].owned.count > 0) {
        searches->list[c][searches->count[c]++] = search_of(levels, view, c, g, ghosts);
    }
}

/* A stencil for each class of a plan with stencils, for the largest row that there may be. One that would be
 * longer than there are particles to find is not worth its memory and time: then windows do, which go through
 * the occupied pencils instead. */
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
    for (int c = 0; c < view->classes; c++) {
        if (levels->plan.grid_of[c] == h) {
            double range[2];
            margin_range(levels, view, c, g, range);
            margin = fmax(margin, range[1] * frame->scale);
        }
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
        if (plan->stencils) {
            make_stencils(levels, view, c);
        }
    }
}
