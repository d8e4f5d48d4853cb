/* SPDX-License-Identifier: BSD-3-Clause */
/* The search in plain C with counters in it. Read bench_events.h first. */
#include "tests/index/bench_events.h"

#include "base/memory.h"
#include "index/choose/auto_choose.h"
#include "index/levels/levels.h"
#include "index/levels/levels_plan.h"

#include <stdlib.h>

static double event[COST_TERMS];

#define SEARCH_EVENT(term, n) (event[term] += (double)(n))
#include "index/search/lanes_plain.h"
#include "index/search/search_rows.h"

static int compare_doubles(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void bench_describe(const struct index_view *view, double skin, struct cost_scene *scene) {
    double *radii = memory_allocate(view->owned, sizeof *radii, "radii");
    for (size_t k = 0; k < view->owned; k++) {
        radii[k] = view->radius[k * view->stride];
    }
    qsort(radii, view->owned, sizeof *radii, compare_doubles);
    *scene = (struct cost_scene){
        .volume = view->edge[0] * view->edge[1] * view->edge[2], .dimension = 3, .threads = view->threads};
    auto_bins(scene, radii, view->owned, 1);
    for (int bin = 0; bin < scene->bins; bin++) {
        scene->margin[bin] = skin * scene->radius_min[bin];
    }
    memory_free(radii);
}

void bench_classes(struct bench_scene *packing, const struct cost_scene *scene, const struct cost_plan *plan,
                   double skin) {
    struct index_view *view = &packing->view;
    double least[INDEX_CLASS_MAX];
    view->classes = plan->levels;
    for (int c = 0; c < plan->levels; c++) {
        int first = c > 0 ? plan->last[c - 1] + 1 : 0;
        least[c] = scene->radius_min[first];
        view->radius_max[c] = scene->radius_max[plan->last[c]];
    }
    for (int a = 0; a < plan->levels; a++) {
        for (int b = 0; b < plan->levels; b++) {
            view->margin[a][b] = skin * least[a < b ? a : b];
        }
    }
    for (size_t k = 0; k < view->owned; k++) {
        int c = 0;
        while (c < plan->levels - 1 && packing->record[k * BENCH_STRIDE + 3] > view->radius_max[c]) {
            c++;
        }
        packing->size_class[k] = (uint8_t)c;
    }
}

/* Half a visit for each row of a level that gets its pairs with a larger level from there, as the model has it. */
static double handed_out(const struct levels *levels, const struct index_view *view) {
    double visits = 0;
    for (int c = 0; c < view->classes; c++) {
        for (int s = 0; s < levels->cross_searches.count[c]; s++) {
            visits += 0.5 * (double)levels->cross_searches.list[c][s].cells->count;
        }
    }
    return visits;
}

void bench_events(struct bench_scene *packing, const struct cost_plan *plan, double count[COST_TERMS]) {
    const struct index_params params = {.instructions = INDEX_PLAIN};
    struct index_view *view = &packing->view;
    struct index_sink none = {0};
    struct levels levels = {0};
    struct levels_plan cells = {.grids = plan->levels};
    uint32_t *order = memory_allocate(view->owned, sizeof *order, "order");
    for (int g = 0; g < plan->levels; g++) {
        cells.edge[g] = plan->edge[g];
        cells.fixed[g] = true;
        cells.grid_of[g] = g;
    }
    levels_plan_apart(&cells, view);
    levels_start(&levels, &params);
    levels_order(&levels, &cells, view, order);
    bench_scene_reorder(packing, order);
    levels_build(&levels, &cells, view);
    for (int t = 0; t < COST_TERMS; t++) {
        event[t] = 0;
    }
    search_rows(&levels, &levels.cross_searches, view, 0, view->owned, &none);
    search_rows(&levels, &levels.searches, view, 0, view->owned, &none);
    event[COST_PARTICLE] = (double)view->owned;
    for (int g = 0; g < levels.plan.grids; g++) {
        const struct level *level = &levels.level[g];
        event[COST_CELL] += level->owned.sparse ? 0 : level->grid.cells;
    }
    event[COST_VISIT] += handed_out(&levels, view);
    for (int t = 0; t < COST_TERMS; t++) {
        count[t] = event[t];
    }
    levels_free(&levels);
    memory_free(order);
}
