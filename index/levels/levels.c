/* SPDX-License-Identifier: BSD-3-Clause */
/* A set of grids: laid, built, searched, checked, described. Read levels.h first. */
#include "index/levels/levels.h"

#include "base/image.h"
#include "base/memory.h"
#include "index/levels/levels_plan.h"
#include "index/levels/levels_stay.h"
#include "index/search/search.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    X_CELLS = 2,      /* cells in x for one in y or z: they cost only a table entry */
    VISIT_ROWS = 128, /* rows between two lots of pairs with larger particles */
};

/* Factor by which an edge that the user did not fix may grow to keep the grid dense. */
static const double GROWTH = 2.5;

void levels_start(struct levels *levels, const struct index_params *params) {
    int best = search_instructions();
    int wanted = params->instructions;
    levels->instructions = wanted > INDEX_BEST && wanted < best ? wanted : best;
    levels->cross_search = params->cross_search;
    levels->searches.list =
        memory_allocate_zero(INDEX_CLASS_MAX, sizeof levels->searches.list[0], "index searches");
    levels->cross_searches.list =
        memory_allocate_zero(INDEX_CLASS_MAX, sizeof levels->searches.list[0], "index searches");
}

void levels_free(struct levels *levels) {
    for (int g = 0; g < INDEX_CLASS_MAX; g++) {
        cells_free(&levels->level[g].owned);
        cells_free(&levels->level[g].ghosts);
        stencil_free(&levels->stencil[g]);
    }
    members_free(&levels->owned);
    members_free(&levels->ghosts);
    cells_scratch_free(&levels->scratch);
    cells_free(&levels->order_cells);
    memory_free(levels->slot_of);
    cross_free(&levels->cross);
    levels_stay_free(&levels->stay);
    memory_free(levels->searches.list);
    memory_free(levels->cross_searches.list);
}

void levels_release(struct levels *levels) {
    const struct index_params params = {.instructions = levels->instructions,
                                        .cross_search = levels->cross_search};
    levels_free(levels);
    *levels = (struct levels){0};
    levels_start(levels, &params);
}

/* The number of cells of this edge in the extent of the owned particles; *directions: the number of
 * directions with several cells. */
static double cells_of(const struct frame *frame, double edge, int *directions) {
    double cells = 1;
    *directions = 0;
    for (int d = 0; d < 3; d++) {
        double n = ((double)frame->owned_high[d] - frame->owned_low[d]) * frame->unit / edge;
        *directions += n > 1;
        cells *= n > 1 ? n : 1;
    }
    return cells * X_CELLS;
}

/* Lays out grid g for `owned` owned particles, with the wanted edge, or with a somewhat larger one if this
 * keeps the grid dense. */
static void lay_grid(struct levels *levels, int g, size_t owned) {
    const struct frame *frame = &levels->frame;
    double edge = levels->plan.edge[g];
    int directions;
    double cells = cells_of(frame, edge, &directions);
    if (!levels->plan.fixed[g]) {
        edge *= levels_growth(cells, (double)owned, directions);
    }
    grid_make(&levels->level[g].grid, frame, edge, edge / X_CELLS);
}

double levels_cells(double volume, double edge, int dimension) {
    return X_CELLS * volume / pow(edge, dimension);
}

double levels_growth(double cells, double particles, int directions) {
    const double room = LEVELS_CELLS_A_PARTICLE * particles * 0.9 + LEVELS_CELLS_FREE * 0.5;
    const double growth = cells > room && directions > 0 ? pow(cells / room, 1.0 / directions) : 1;
    return growth <= GROWTH ? growth : 1;
}

bool levels_too_many_cells(double cells, double particles) {
    return cells > LEVELS_CELLS_A_PARTICLE * particles + LEVELS_CELLS_FREE || cells > 0x1p31;
}

static bool too_many_cells(const struct grid *grid, size_t particles) {
    return levels_too_many_cells(grid->cells, (double)particles);
}

static size_t members_count(const struct members *members, int group) {
    return members->begin[group + 1] - members->begin[group];
}

static void reserve_slot_of(struct levels *levels, size_t owned) {
    if (owned > levels->slot_capacity || levels->slot_of == NULL) {
        memory_free(levels->slot_of);
        levels->slot_of = memory_allocate(owned, sizeof(uint32_t), "index slots");
        levels->slot_capacity = owned;
    }
}

static void empty_level(struct level *level) {
    level->owned.count = level->ghosts.count = 0;
}

/* Builds the tables of grid g. The table of the owned particles is only completed if it was kept, and is there if
 * they stayed in their slots. */
static void build_level(struct levels *levels, const struct index_view *view, int g, bool stayed) {
    struct level *level = &levels->level[g];
    size_t owned = members_count(&levels->owned, g), ghosts = members_count(&levels->ghosts, g);
    if (!levels->kept && !stayed) {
        lay_grid(levels, g, owned);
    }
    struct cells_source source = {.view = view,
                                  .frame = &levels->frame,
                                  .grid = &level->grid,
                                  .members = &levels->owned,
                                  .group = g,
                                  .sparse = too_many_cells(&level->grid, owned + ghosts)};
    if (levels->kept) {
        cells_fill(&level->owned, &source, levels->slot_of);
    } else if (!stayed) {
        cells_build(&level->owned, &levels->scratch, &source, levels->slot_of);
    }
    source.members = &levels->ghosts;
    source.sparse = source.sparse || (ghosts == 0 && level->grid.cells > LEVELS_CELLS_FREE);
    cells_build(&level->ghosts, &levels->scratch, &source, NULL);
    levels->frame.clamped = levels->frame.clamped || level->owned.clamped || level->ghosts.clamped;
}

static void search_smaller(const void *context, const struct index_view *view, size_t first, size_t last,
                           struct index_sink *sink) {
    const struct levels *levels = context;
    search_run(levels, &levels->cross_searches, view, first, last, sink);
}

/* The pairs of unlike levels that are found from the larger side. */
static void find_cross(struct levels *levels, const struct index_view *view) {
    int lowest = INDEX_CLASS_MAX; /* the first grid whose particles search smaller ones */
    for (int c = 0; c < view->classes; c++) {
        int grid = levels->plan.grid_of[c];
        lowest = levels->cross_searches.count[c] > 0 && grid < lowest ? grid : lowest;
    }
    if (lowest == INDEX_CLASS_MAX || view->owned == 0) {
        cross_clear(&levels->cross);
        return;
    }
    struct cross_finder finder = {.owned = &levels->owned,
                                  .first = levels->owned.begin[lowest],
                                  .context = levels,
                                  .find = search_smaller};
    cross_find(&levels->cross, &finder, view);
}

/* True if a grid of all particles, with the cells around, has too many cells for the owned ones. */
static bool some_sparse(const struct levels *levels, const size_t owned[INDEX_CLASS_MAX]) {
    bool some = false;
    for (int g = 0; g < levels->plan.grids; g++) {
        some = some || (!levels->plan.idle[g] && too_many_cells(&levels->level[g].grid, owned[g]));
    }
    return some;
}

/* Builds the tables of all grids. */
static void build_tables(struct levels *levels, const struct index_view *view, bool stayed) {
    levels->stay.turned = levels->stay.turned && stayed;
    if (!stayed) {
        levels->stay.builds = 0;
        levels->stay.growth = levels->stay.owing = 0;
    }
    for (int g = 0; g < levels->plan.grids; g++) {
        if (levels->plan.idle[g]) {
            empty_level(&levels->level[g]);
        } else {
            build_level(levels, view, g, stayed);
        }
    }
}

void levels_build(struct levels *levels, const struct levels_plan *plan, const struct index_view *view) {
    const bool in_order = view->ordered && levels->owned.begin[INDEX_CLASS_MAX] == view->owned &&
                          levels_same_grids(plan, &levels->plan, view->classes);
    const bool stayed = levels->stay.due && in_order && levels_stay_follow(levels, view) &&
                        grid_frame_meet(&levels->frame, view);
    levels->kept = levels->kept && in_order && grid_frame_meet(&levels->frame, view);
    levels->plan = *plan;
    if (levels->kept) {
        levels->owned.contiguous = true;
    } else if (!stayed) {
        grid_frame_make(&levels->frame, view);
        members_split(&levels->owned, view, 0, view->owned, plan->grid_of);
    }
    members_split(&levels->ghosts, view, view->owned, view->total, plan->grid_of);
    reserve_slot_of(levels, view->owned);
    build_tables(levels, view, stayed);
    levels_stay_note(levels, view, levels->kept || stayed);
    levels->kept = false;
    for (int c = 0; c < INDEX_CLASS_MAX; c++) {
        levels->radius_max[c] = c < view->classes ? view->radius_max[c] : 0;
        levels->radius_min[c] = c > 0 ? levels->radius_max[c - 1] : 0;
    }
    levels_plan_searches(levels, view);
    find_cross(levels, view);
}

bool levels_stays(struct levels *levels, const struct levels_plan *plan, const struct index_view *view) {
    levels->stay.due = levels_stay_pays(levels, plan, view);
    return levels->stay.due;
}

void levels_order(struct levels *levels, const struct levels_plan *plan, const struct index_view *view,
                  uint32_t *order) {
    levels->stay.due = false;
    levels->plan = *plan;
    grid_frame_make(&levels->frame, view);
    int class_of[INDEX_CLASS_MAX];
    size_t owned[INDEX_CLASS_MAX] = {0};
    for (int c = 0; c < INDEX_CLASS_MAX; c++) {
        class_of[c] = c;
    }
    members_split(&levels->owned, view, 0, view->owned, class_of);
    for (int c = 0; c < view->classes; c++) {
        owned[plan->grid_of[c]] += members_count(&levels->owned, c);
    }
    for (int g = 0; g < plan->grids; g++) {
        if (!plan->idle[g]) {
            lay_grid(levels, g, owned[g]);
        }
    }
    levels->kept = plan->grids == view->classes && /* then each grid has one class */
                   !(view->around.known && some_sparse(levels, owned));
    for (int c = 0; c < view->classes; c++) {
        struct level *level = &levels->level[plan->grid_of[c]];
        size_t count = members_count(&levels->owned, c);
        if (plan->idle[plan->grid_of[c]]) { /* no cells: the particles keep their order */
            for (size_t k = levels->owned.begin[c]; k < levels->owned.begin[c + 1]; k++) {
                order[k] = (uint32_t)members_get(&levels->owned, k);
            }
            continue;
        }
        struct cells_source source = {.view = view,
                                      .frame = &levels->frame,
                                      .grid = &level->grid,
                                      .members = &levels->owned,
                                      .group = c,
                                      .sparse = too_many_cells(&level->grid, count)};
        cells_order(levels->kept ? &level->owned : &levels->order_cells, &levels->scratch, &source,
                    levels->kept, order + levels->owned.begin[c]);
    }
}

/* Emits pairs with larger particles soon after the other pairs of their rows, so that the pairs of a row lie
 * close together in the list. */
void levels_visit(const struct levels *levels, const struct index_view *view, size_t first, size_t last,
                  struct index_sink *sink) {
    const size_t step = levels->cross.rows > 0 ? VISIT_ROWS : last - first;
    for (size_t row = first, end; row < last; row = end) {
        end = row + step < last ? row + step : last;
        search_run(levels, &levels->searches, view, row, end, sink);
        cross_visit(&levels->cross, row, end, sink);
    }
}

/* The coordinates of a slot after moves: those of its particle, in the image of its turn, no farther from the origin
 * than the drift. */
static bool near_origin(const struct levels *levels, const struct index_view *view, const struct cells *cells,
                        size_t slot) {
    const size_t i = cells->particle[slot];
    const float at[3] = {cells->x[slot], cells->y[slot], cells->z[slot]};
    int image[3];
    double square = 0;
    bool there = true;
    image_vector(levels->stay.turn[i], image);
    for (int d = 0; d < 3; d++) {
        double x = view->position[i * view->stride + (size_t)d] + image[d] * view->edge[d];
        there = there && at[d] == grid_frame_coordinate(&levels->frame, d, x);
        square += ((double)at[d] - cells->origin[d][slot]) * ((double)at[d] - cells->origin[d][slot]);
    }
    return there && sqrt(square) <= cells->drift;
}

/* Every slot holds the particle it should, in the cell it should. */
static bool check_cells(const struct levels *levels, const struct index_view *view, const struct level *level,
                        const struct cells *cells, char why[INDEX_WHY_MAX]) {
    for (size_t slot = 0; slot < cells->count; slot++) {
        size_t i = cells->particle[slot];
        const double *x = view->position + i * view->stride;
        int cell[3];
        for (int d = 0; d < 3; d++) {
            cell[d] = grid_cell(&level->grid, d,
                                cells->moved ? cells->origin[d][slot]
                                             : grid_frame_coordinate(&levels->frame, d, x[d]));
        }
        if (cells->moved && !near_origin(levels, view, cells, slot)) {
            snprintf(why, INDEX_WHY_MAX, "particle %zu has moved farther than the drift of its table", i);
            return false;
        }
        struct cells_slice slice = cells_run(cells, &level->grid, cell[0], cell[0], cell[1], cell[2]);
        bool known = i >= view->owned || levels->slot_of[i] == slot;
        if (slot < slice.begin || slot >= slice.end || !known) {
            snprintf(why, INDEX_WHY_MAX, "particle %zu is in a wrong slot or cell", i);
            return false;
        }
        if (slot > slice.begin && cells->particle[slot - 1] >= i) {
            snprintf(why, INDEX_WHY_MAX, "particle %zu is out of order in its cell", i);
            return false;
        }
    }
    for (size_t slot = cells->count; cells->count > 0 && slot < cells->count + CELLS_PAD; slot++) {
        if (!(cells->x[slot] >= 1e30f && cells->y[slot] >= 1e30f && cells->z[slot] >= 1e30f &&
              cells->r[slot] == 0)) {
            snprintf(why, INDEX_WHY_MAX, "what stands behind the last slot is not far from everybody");
            return false;
        }
    }
    return true;
}

bool levels_check(const struct levels *levels, const struct index_view *view, char why[INDEX_WHY_MAX]) {
    size_t owned = 0, ghosts = 0;
    for (int g = 0; g < levels->plan.grids; g++) {
        const struct level *level = &levels->level[g];
        owned += levels->plan.idle[g] ? members_count(&levels->owned, g) : level->owned.count;
        ghosts += levels->plan.idle[g] ? members_count(&levels->ghosts, g) : level->ghosts.count;
        if (!check_cells(levels, view, level, &level->owned, why) ||
            !check_cells(levels, view, level, &level->ghosts, why)) {
            return false;
        }
    }
    if (owned != view->owned || ghosts != view->total - view->owned) {
        snprintf(why, INDEX_WHY_MAX, "%zu owned particles and %zu ghosts indexed, of %zu and %zu", owned,
                 ghosts, view->owned, view->total - view->owned);
        return false;
    }
    return true;
}

void levels_describe(const struct levels *levels, struct index_description *description) {
    description->levels = levels->plan.grids;
    for (int g = 0; g < levels->plan.grids; g++) {
        const struct level *level = &levels->level[g];
        struct index_level *line = &description->level[g];
        if (levels->plan.idle[g]) {
            line->particles = members_count(&levels->owned, g) + members_count(&levels->ghosts, g);
        } else {
            line->cell = (double)level->grid.size[1] * levels->frame.unit;
            line->sparse = level->owned.sparse;
            line->cells = level->owned.sparse ? level->owned.occupied : (size_t)level->grid.cells;
            line->particles = level->owned.count + level->ghosts.count;
        }
        line->radius_min = INFINITY;
        for (int c = 0; c < INDEX_CLASS_MAX; c++) {
            if (levels->plan.grid_of[c] == g && levels->radius_max[c] > 0) {
                line->radius_min = fmin(line->radius_min, levels->radius_min[c]);
                line->radius_max = fmax(line->radius_max, levels->radius_max[c]);
            }
        }
        line->radius_min = fmin(line->radius_min, line->radius_max);
    }
}

size_t levels_memory(const struct levels *levels) {
    size_t bytes = levels->slot_capacity * sizeof(uint32_t) + levels->stay.capacity +
                   cells_scratch_memory(&levels->scratch) + cells_memory(&levels->order_cells) +
                   (levels->owned.capacity + levels->ghosts.capacity) * sizeof(uint32_t) +
                   2 * INDEX_CLASS_MAX * sizeof levels->searches.list[0] + cross_memory(&levels->cross);
    for (int g = 0; g < INDEX_CLASS_MAX; g++) {
        bytes += cells_memory(&levels->level[g].owned) + cells_memory(&levels->level[g].ghosts) +
                 levels->stencil[g].capacity * sizeof(struct stencil_run);
    }
    return bytes;
}
